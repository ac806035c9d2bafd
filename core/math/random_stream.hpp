#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::math {

/// Random numbers that are the same with every compiler (the standard library's distributions are
/// not): SplitMix64 from the first 64 bits of SHA-256("<seed>/<purpose>").
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::string_view purpose);

  double uniform();  ///< [0, 1)
  double uniform(double from, double to) { return from + (to - from) * uniform(); }
  /// Of a range {from, to}.
  double uniform(const std::vector<double>& range) { return uniform(range[0], range[1]); }
  bool chance(double share) { return uniform() < share; }
  int whole(const std::vector<double>& range);  ///< from … to, both included
  double normal();                              ///< mean 0, variance 1 (Marsaglia's polar method)
  Vec3 normals() {
    const double x = normal(), y = normal();
    return {x, y, normal()};
  }
  Quat rotation();  ///< uniform over all rotations

 private:
  std::uint64_t next();

  std::uint64_t state_;
  double spare_ = 0;
  bool has_spare_ = false;
};

}  // namespace morphe::math
