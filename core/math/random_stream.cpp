#include "core/math/random_stream.hpp"

#include <cmath>

#include "core/math/seed.hpp"

namespace morphe::math {

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

int RandomStream::uniform_integer(const std::vector<double>& range) {
  return static_cast<int>(range[0] + std::floor((range[1] - range[0] + 1) * uniform()));
}

double RandomStream::normal() {
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  double x = 0, y = 0, square = 0;
  do {
    x = 2 * uniform() - 1;
    y = 2 * uniform() - 1;
    square = x * x + y * y;
  } while (square >= 1 || square == 0);
  const double scale = std::sqrt(-2 * std::log(square) / square);
  spare_ = scale * y;
  has_spare_ = true;
  return scale * x;
}

Quat RandomStream::rotation() {
  Eigen::Vector4d coefficients;
  for (int k = 0; k < 4; ++k) coefficients[k] = normal();
  return Quat(Eigen::Vector4d(coefficients.normalized()));
}

}  // namespace morphe::math
