#pragma once

#include <string>

#include "core/motion/plan.hpp"
#include "stages/export/joint_group.hpp"

namespace morphe::exports {

/// A row per sample under one line of names:
///   time_s, demonstration_time_s, phase, <joint>_position_rad …, <joint>_velocity_rad_s …,
///   <joint>_acceleration_rad_s2 …
/// in the group's order of joints; of a joint that slides _position_m, _velocity_m_s,
/// _acceleration_m_s2. Numbers have as many digits as it takes to read back the same double; a name
/// with a comma or a quote is quoted (RFC 4180), lines end with a line feed.
std::string trajectory_csv(const JointGroup& group, const Trajectory& trajectory);

}  // namespace morphe::exports
