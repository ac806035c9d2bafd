#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::math {

/// Random numbers that are identical with every compiler (the standard library's distributions are
/// not): SplitMix64, seeded with the first 64 bits of SHA-256("<seed>/<purpose>").
class RandomStream {
 public:
  /// Starts the sequence of a seed and a purpose.
  RandomStream(std::uint64_t seed, std::string_view purpose);

  /// Returns a number uniformly distributed in [0, 1).
  double uniform();
  /// Returns a number uniformly distributed in [from, to).
  double uniform(double from, double to) { return from + (to - from) * uniform(); }
  /// Returns a number uniformly distributed in a range {from, to}.
  double uniform(const std::vector<double>& range) { return uniform(range[0], range[1]); }
  /// Returns true with this probability.
  bool bernoulli(double probability) { return uniform() < probability; }
  /// Returns an integer uniformly distributed in {from, to}, including both.
  int uniform_integer(const std::vector<double>& range);
  /// Returns a normally distributed number with mean 0 and variance 1 (Marsaglia's polar method).
  double normal();
  /// Returns three independent normally distributed numbers.
  Vec3 normal_vector3() {
    const double x = normal(), y = normal();
    return {x, y, normal()};
  }
  /// Returns a rotation uniformly distributed over all rotations.
  Quat rotation();

 private:
  std::uint64_t next();

  std::uint64_t state_;
  double spare_ = 0;
  bool has_spare_ = false;
};

}  // namespace morphe::math
