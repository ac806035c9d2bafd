#pragma once

#include <string>

#include "pipeline/motion/plan.hpp"
#include "pipeline/motion/robot_table.hpp"

namespace morphe::exports {

/// A trajectory_msgs/msg/JointTrajectory of ROS 2 as YAML: the actuated joints by name, and a point
/// per sample with position, velocity, acceleration and time_from_start. The stamp is zero (begin
/// at once), the frame "base". time_from_start is rounded to nanoseconds and still increases
/// strictly: where two samples would share one, the later gets the next. Every number has a decimal
/// point: YAML 1.1, as ROS reads it, takes 1e-05 for text.
std::string ros_trajectory(const RobotTable& robot, const Trajectory& trajectory);

}  // namespace morphe::exports
