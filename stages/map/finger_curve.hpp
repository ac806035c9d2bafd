#pragma once

#include <array>

#include "core/motion/geometry.hpp"

namespace morphe::map {

/// Returns the goal of a finger of a hand without five fingers (the paper's rule): the point at
/// `share` (0 … 1) of the arc length of the natural cubic spline in the chord length through the
/// human's index, middle, ring and little fingertips (or joints), to 1e-9 m. Returns an unseen
/// point if one of the four is unseen or two neighbours coincide.
Vec3 finger_curve_point(const std::array<Vec3, 4>& fingers, double share);

}  // namespace morphe::map
