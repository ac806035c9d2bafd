#include "stages/synthesize/random_stream.hpp"

#include <cmath>
#include <numbers>

#include "pipeline/config/hash.hpp"

namespace morphe {

RandomStream::RandomStream(std::uint64_t seed, std::string_view purpose)
    : state_(seed_from(seed, purpose)) {}

std::uint64_t RandomStream::next() {
  state_ += 0x9e3779b97f4a7c15U;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

double RandomStream::uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }

int RandomStream::whole(const FromTo& range) {
  return static_cast<int>(range[0] + std::floor((range[1] - range[0] + 1) * uniform()));
}

double RandomStream::normal() {
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  const double radius = std::sqrt(-2 * std::log(1 - uniform()));
  const double angle = 2 * std::numbers::pi * uniform();
  spare_ = radius * std::sin(angle);
  has_spare_ = true;
  return radius * std::cos(angle);
}

Quat RandomStream::rotation() {
  Eigen::Vector4d coefficients;
  for (int k = 0; k < 4; ++k) coefficients[k] = normal();
  return Quat(Eigen::Vector4d(coefficients.normalized()));
}

}  // namespace morphe
