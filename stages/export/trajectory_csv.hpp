#pragma once

#include <string>

#include "pipeline/motion/plan.hpp"
#include "pipeline/motion/robot_table.hpp"

namespace morphe::exports {

/// A row per sample under one line of names:
///   time_s, demonstration_time_s, phase, <joint>_position_rad …, <joint>_velocity_rad_s …,
///   <joint>_acceleration_rad_s2 …
/// in the robot's order of joints. Numbers have 17 significant digits, enough to read back the same
/// double; a name with a comma or a quote is quoted (RFC 4180), lines end with a line feed.
std::string trajectory_csv(const RobotTable& robot, const Trajectory& trajectory);

}  // namespace morphe::exports
