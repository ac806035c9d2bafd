#pragma once

#include <functional>

#include "core/human/glove.hpp"
#include "core/motion/demonstration.hpp"
#include "pipeline/synthesize/sensor_noise.hpp"
#include "pipeline/synthesize/synthesize_options.hpp"

namespace morphe::synthesize {

/// What each sensor of one glove reads too much [rad].
using GloveBias = Eigen::Matrix<double, static_cast<int>(human::kGloveSensorCount), 1>;
GloveBias draw_bias(const SyntheticGlove& options, math::RandomStream& random);

/// What the glove says of a hand over [0, length_s], reading(t) being what an ideal one would; its
/// clock reads `clock_offset_s` more than t.
HandStream simulate_glove(const SyntheticGlove& options, const GloveBias& bias,
                          const std::function<human::GloveAngles(double time_s)>& reading,
                          double length_s, double clock_offset_s, math::RandomStream& random);
/// Replaces what was lost by NaN.
void drop(const SyntheticGlove& options, math::RandomStream& random, HandStream& glove);

}  // namespace morphe::synthesize
