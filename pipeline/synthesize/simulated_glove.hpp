#pragma once

#include <functional>

#include "core/human/glove.hpp"
#include "core/motion/demonstration.hpp"
#include "pipeline/synthesize/sensor_noise.hpp"
#include "pipeline/synthesize/synthesize_options.hpp"

namespace morphe::synthesize {

/// The constant error of each sensor of one glove [rad].
using GloveBias = Eigen::Matrix<double, human::kGloveSensorCount, 1>;
/// Draws the errors of a glove.
GloveBias draw_bias(const SyntheticGlove& options, math::RandomStream& random);

/// Simulates a glove over [0, length_s], given the readings of an ideal one at a time. The times of
/// the stream are on the glove's clock, which is ahead by `clock_offset_s`.
HandStream simulate_glove(const SyntheticGlove& options, const GloveBias& bias,
                          const std::function<human::GloveAngles(double time_s)>& reading,
                          double length_s, double clock_offset_s, math::RandomStream& random);
/// Draws lost samples and replaces them by NaN, all sensors at once.
void apply_dropouts(const SyntheticGlove& options, math::RandomStream& random, HandStream& glove);

}  // namespace morphe::synthesize
