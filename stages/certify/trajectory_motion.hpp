#pragma once

#include "core/collision/continuous_check.hpp"
#include "core/motion/plan.hpp"

namespace morphe::certify {

/// Returns a trajectory as a motion over time that can be certified: the quintics between the
/// samples. Within [s0, s1] the distance of a joint from its middle position is bounded by the
/// largest speed of each piece. The trajectory must outlive the motion and have at least two
/// samples.
collision::JointMotion trajectory_motion(const Trajectory& trajectory);

/// Returns the demonstration time at a time [s], linear between the samples.
double demonstration_time_at(const Trajectory& trajectory, double time_s);

/// Returns the sample at or before a time, but never the last one.
std::size_t sample_before(const Trajectory& trajectory, double time_s);

}  // namespace morphe::certify
