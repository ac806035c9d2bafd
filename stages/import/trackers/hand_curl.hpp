#pragma once

#include "core/motion/geometry.hpp"

namespace morphe::imports {

inline constexpr double kMinCurl_m = 0.010;  ///< straighter fingers do not determine the side

/// Returns the mean displacement of the fingertips, without the thumb's, from their knuckles over
/// [N, 21] keypoints, along the normal out of the back of a right hand or the palm of a left one
/// [m]; NaN if unknown. Below -kMinCurl_m it is a right hand, above kMinCurl_m a left one.
double finger_curl_m(const Array2D<Vec3>& keypoints);

}  // namespace morphe::imports
