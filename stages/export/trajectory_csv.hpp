#pragma once

#include <string>

#include "core/motion/plan.hpp"
#include "stages/export/joint_group.hpp"

namespace morphe::exports {

/// Returns the trajectory as a table, one row per sample below a line of names:
///   time_s, demonstration_time_s, phase, <joint>_position_rad …, <joint>_velocity_rad_s …,
///   <joint>_acceleration_rad_s2 …
/// in the group's order of joints; for a prismatic joint _position_m, _velocity_m_s,
/// _acceleration_m_s2. Numbers have the digits necessary to restore the same double; a name with a
/// comma or a quote is quoted (RFC 4180), lines end with a line feed.
std::string trajectory_csv(const JointGroup& group, const Trajectory& trajectory);

}  // namespace morphe::exports
