#pragma once

#include <string>
#include <vector>

#include "core/robot/files/description.hpp"

namespace morphe::describe {

/// What can be loaded but is hardly meant: a joint that moves no tip, a tip beside the palm, a palm
/// beside the shoulder, a finger without a centre, links without a shape; and what the description
/// left out. One line each.
std::vector<std::string> remarks(const robot::RobotDescription& description);

/// Greatest distance of a tip from the shoulder, were all links stretched: the sum of the distances
/// between the frames on the way [m].
double stretched_reach(const RobotTable& robot, const RobotTable::Tip& tip);

/// Tables for a person: joints with their limits, couplings, frames, tips, centres, remarks.
std::string robot_text(const robot::RobotDescription& description);
/// The same as JSON, in SI units.
std::string robot_json(const robot::RobotDescription& description);

}  // namespace morphe::describe
