#pragma once

#include <string>
#include <vector>

#include "core/robot/files/description.hpp"

namespace morphe::describe {

/// Returns the description's notes, and one on each joint that moves no tip, palm not moved by the
/// shoulder, tip not moved by the palm, finger without a joint centre, and links without a shape.
std::vector<std::string> plausibility_notes(const robot::RobotDescription& description);

/// Returns the sum of the distances between consecutive frames from the shoulder to a tip [m].
double stretched_reach(const RobotModel& robot, const RobotModel::Tip& tip);

/// Returns tables for display: joints with their limits, couplings, frames, tips, centres, remarks.
std::string robot_text(const robot::RobotDescription& description);
/// Returns the same data as JSON, in SI units.
std::string robot_json(const robot::RobotDescription& description);

}  // namespace morphe::describe
