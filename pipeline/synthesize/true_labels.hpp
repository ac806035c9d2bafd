#pragma once

#include <vector>

#include "core/motion/demonstration.hpp"
#include "pipeline/synthesize/motion_samples.hpp"

namespace morphe::synthesize {

/// The phases of a script as the motion without noise and tremor shows them, in the order reach,
/// preshape, grasp, transport, hold, transport, hold, return (a touch: reach, hold, return); what
/// is not labelled is rest. A bout of motion (reach, transport, return) lasts from the first to the
/// last crossing of 5 % of its own peak by the index tip's speed, central differences interpolated
/// in time; pauses and dips inside it belong to it, and two bouts meet at the slowest instant of
/// the pause that was meant between them. Preshape begins where the opening has made 10 % of its
/// rise over the reach and ends with the reach. The return begins with the fingers' release.
///
/// Times count from script.begin_s and are clipped to what was recorded. A reach whose peak was not
/// recorded is not labelled, nor its preshape.
std::vector<Label> true_labels(const Script& script, const MotionSamples& samples);

}  // namespace morphe::synthesize
