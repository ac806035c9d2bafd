#pragma once

#include <string>

#include "core/motion/plan.hpp"
#include "stages/export/joint_group.hpp"

namespace morphe::exports {

/// A trajectory_msgs/msg/JointTrajectory of ROS 2: the group's joints by name, and a point per
/// sample, each in a line of its own, with position, velocity, acceleration and time_from_start.
/// The stamp is zero (begin at once), the frame "base". time_from_start is rounded to nanoseconds
/// and still increases strictly: where two samples would share one, the later gets the next.
/// Numbers have as many digits as it takes to read back the same double, and a decimal point: YAML
/// 1.1, as ROS reads it, takes 1e-05 for text. YAML readers take milliseconds a point; the same in
/// JSON is read at once.
std::string ros_trajectory_yaml(const JointGroup& group, const Trajectory& trajectory);
std::string ros_trajectory_json(const JointGroup& group, const Trajectory& trajectory);

}  // namespace morphe::exports
