#pragma once

#include "core/motion/geometry.hpp"

namespace morphe::imports {

/// Fingers that are nearly straight tell no side [m].
inline constexpr double kCurl_m = 0.010;

/// How far the fingers curl out of what would be the back of a right hand: mean over all frames of
/// [N, 21] keypoints [m]. Below -kCurl_m it is a right hand, above kCurl_m a left one; NaN = not
/// seen well enough.
double curl_away_from_right_palm(const Table<Vec3>& keypoints);

}  // namespace morphe::imports
