#pragma once

#include <string>

#include "core/motion/plan.hpp"
#include "stages/export/joint_group.hpp"

namespace morphe::exports {

/// Returns a trajectory_msgs/msg/JointTrajectory of ROS 2 as YAML: the group's joints by name, and
/// one point per sample, each on a line of its own, with position, velocity, acceleration and
/// time_from_start. The stamp is zero (start immediately), the frame "base". time_from_start is
/// rounded to nanoseconds and still increases strictly: a sample that would not be later than the
/// one before it gets the next nanosecond. Numbers have the digits necessary to restore the same
/// double, and a decimal point, because YAML 1.1, which ROS reads, takes 1e-05 for text. YAML
/// readers need milliseconds per point; JSON readers are much faster.
std::string ros_trajectory_yaml(const JointGroup& group, const Trajectory& trajectory);
/// Returns the same message as JSON.
std::string ros_trajectory_json(const JointGroup& group, const Trajectory& trajectory);

}  // namespace morphe::exports
