#pragma once

#include <array>

#include "core/motion/geometry.hpp"

namespace morphe::map {

/// Goals of a hand that has not five fingers (the paper's rule): a natural cubic spline in the
/// chord length through the human's index, middle, ring and little fingertips (or joints), and of
/// it the point at `share` (0 … 1) of its arc length, to 1e-9 m. Unseen if one of the four is.
Vec3 point_along(const std::array<Vec3, 4>& fingers, double share);

}  // namespace morphe::map
