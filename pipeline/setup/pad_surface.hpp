#pragma once

#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::setup {

/// The maximum distance of the pad from the end of a finger [m], half of a human fingertip.
inline constexpr double kPadSetback_m = 0.008;
/// The distance from the surface of the pad to the axis of the finger, to which goals refer [m].
inline constexpr double kPadDepth_m = 0.010;

/// Returns how far the farthest point is from `from` along a direction [m].
double end_along(const std::vector<Vec3>& points, const Vec3& from, const Vec3& direction);

/// Returns the point at the height of the surface along `normal`, slightly before the end of a
/// finger, `end_m` along `bone`, and in the middle of the width. `from` is on the bone; the vectors
/// are unit vectors.
Vec3 pad_surface(const std::vector<Vec3>& points, const Vec3& from, const Vec3& bone,
                 const Vec3& normal, double end_m);

/// Returns the frame with that z axis, and x as near to the given one as possible.
Pose make_frame(const Vec3& origin, const Vec3& x, const Vec3& z);

}  // namespace morphe::setup
