#pragma once

#include "core/motion/geometry.hpp"

namespace morphe::imports {

/// Curl below which the fingers are nearly straight and do not determine the side [m].
inline constexpr double kMinCurl_m = 0.010;

/// Returns the distance by which the fingers curl out of the back of a right hand: the mean over
/// all frames of [N, 21] keypoints [m]. Below -kMinCurl_m it is a right hand, above kMinCurl_m a
/// left one; NaN if not seen well enough.
double finger_curl_m(const Array2D<Vec3>& keypoints);

}  // namespace morphe::imports
