#pragma once

#include "core/motion/geometry.hpp"

namespace morphe::collision {

/// The closest points of two segments.
struct ClosestPoints {
  Vec3 on_first, on_second;
  double squared = 0;  ///< squared distance between them
};

/// Computes min over s, t in [0, 1] of |a + s (b - a) - c - t (d - c)|^2. A segment with a == b or
/// c == d is a point.
ClosestPoints closest_points_of_segments(const Vec3& a, const Vec3& b, const Vec3& c,
                                         const Vec3& d);

}  // namespace morphe::collision
