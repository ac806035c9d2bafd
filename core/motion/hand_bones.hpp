#pragma once

#include <array>

#include "core/motion/geometry.hpp"

namespace morphe {

/// Positions of the knuckles [m] and lengths of a hand's digits in the hand's frame (z to the
/// fingers, y to the thumb, x out of the palm), thumb first. NaN if a digit is missing or unknown.
struct HandBones {
  std::array<Vec3, 5> knuckle{unknown_point(), unknown_point(), unknown_point(), unknown_point(),
                              unknown_point()};
  /// Lengths from the knuckle's axis to the tip of the stretched digit [m].
  std::array<double, 5> length{kUnknown, kUnknown, kUnknown, kUnknown, kUnknown};
};

}  // namespace morphe
