#pragma once

#include "core/collision/certified.hpp"
#include "core/motion/plan.hpp"

namespace morphe::certify {

/// A trajectory as certified motion over its time: the quintics between the samples. Within
/// [s0, s1] a joint gets no farther from its middle position than the way it can make at the
/// largest speed of each piece. The trajectory must outlive the motion and have two samples.
collision::JointMotion trajectory_motion(const Trajectory& trajectory);

/// Linear between the samples [s].
double demonstration_time_at(const Trajectory& trajectory, double time_s);

/// Sample at or before a time, never the last one.
std::size_t sample_before(const Trajectory& trajectory, double time_s);

}  // namespace morphe::certify
