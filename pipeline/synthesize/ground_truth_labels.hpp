#pragma once

#include <vector>

#include "core/motion/demonstration.hpp"
#include "pipeline/synthesize/motion_samples.hpp"

namespace morphe::synthesize {

/// Computes the phases of a script from the motion without noise and tremor, in the order reach,
/// preshape, grasp, transport, hold, transport, hold, return (a touch: reach, hold, return);
/// unlabelled time is rest. `samples` are those of `script`. A segment of motion (reach, transport,
/// return) extends from the first to the last instant at which the speed of the index tip crosses 5
/// % of its peak in the segment; the speed is computed from central differences and interpolated in
/// time. Pauses and dips inside are included. A segment is searched between the slowest instants of
/// the scripted pauses before and after it. Preshape begins when the aperture has made 10 % of its
/// rise over the reach, and ends with the reach. The return begins with the release by the fingers.
///
/// Times count from script.begin_s and are clipped to the recorded interval. A reach whose peak was
/// not recorded is not labelled, and neither is its preshape.
std::vector<Label> ground_truth_labels(const Script& script, const MotionSamples& samples);

}  // namespace morphe::synthesize
