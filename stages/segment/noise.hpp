#pragma once

#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::segment {

/// Noise of a signal that rests now and then: the root mean square of its deviation from a straight
/// line, in windows of a quarter of a second; the value below which a tenth of the windows lies.
/// Straight lines take out slow drift, and most of a movement if the recording holds no rest.
double noise_rms(const std::vector<Vec3>& values, double step_s);
double noise_rms(const std::vector<double>& values, double step_s);

}  // namespace morphe::segment
