#pragma once

#include <array>

#include "core/motion/geometry.hpp"

namespace morphe::map {

/// Returns a point on the curve through the human's index, middle, ring and little fingertips (or
/// joints), the goal of a finger of a hand without five fingers (the paper's rule). The curve is a
/// natural cubic spline in the chord length; the point is at `share` (0 … 1) of its arc length, to
/// 1e-9 m. Returns an unseen point if one of the four is unseen.
Vec3 finger_curve_point(const std::array<Vec3, 4>& fingers, double share);

}  // namespace morphe::map
