#pragma once

#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::segment {

/// Estimates the noise of a signal that is at rest now and then. It is the 10th percentile, over
/// windows of a quarter of a second, of the root mean square deviation from a straight line. The
/// straight lines remove slow drift, and most of a movement if the recording contains no rest.
double noise_rms(const std::vector<Vec3>& values, double step_s);
double noise_rms(const std::vector<double>& values, double step_s);

}  // namespace morphe::segment
