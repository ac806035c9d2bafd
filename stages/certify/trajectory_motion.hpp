#pragma once

#include "core/collision/continuous_check.hpp"
#include "core/motion/plan.hpp"

namespace morphe::certify {

/// Returns the quintics between a trajectory's samples as a motion over the trajectory's time. Its
/// bound on how far a joint moves within [s0, s1] from its position in the middle uses the largest
/// speed of each quintic. The trajectory must outlive the motion and have at least two samples.
collision::JointMotion trajectory_motion(const Trajectory& trajectory);

/// Returns the last sample at or before a time, but at least the first and at most the last but
/// one.
std::size_t sample_before(const Trajectory& trajectory, double time_s);

}  // namespace morphe::certify
