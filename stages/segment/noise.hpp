#pragma once

#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::segment {

/// Returns the noise, in the unit of the values, of a signal that is at rest now and then: the 10th
/// percentile, over windows of a quarter of a second, of the rms deviation from a straight line.
/// The lines remove slow drift, and most of a movement if the recording contains no rest. All
/// values are known, `step_s` apart. Returns 0 if they are fewer than a window contains.
double noise_rms(const std::vector<Vec3>& values, double step_s);
double noise_rms(const std::vector<double>& values, double step_s);

}  // namespace morphe::segment
