#pragma once

#include <random>

#include "core/motion/geometry.hpp"

namespace morphe::verify {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double in(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  Vec3 point(double reach) { return {in(-reach, reach), in(-reach, reach), in(-reach, reach)}; }

 private:
  std::mt19937 engine_;
};

}  // namespace morphe::verify
