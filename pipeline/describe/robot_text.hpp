#pragma once

#include <string>
#include <vector>

#include "core/robot/files/description.hpp"

namespace morphe::describe {

/// Returns notes about valid but implausible properties: a joint that moves no tip, a tip not
/// attached to the palm, a palm not attached to the shoulder, a finger without a centre, links
/// without a shape; and the notes of the description about omitted parts. There is one line for
/// each.
std::vector<std::string> plausibility_notes(const robot::RobotDescription& description);

/// Returns the distance of a tip from the shoulder with all links stretched: the sum of the
/// distances between the frames along the chain [m].
double stretched_reach(const RobotModel& robot, const RobotModel::Tip& tip);

/// Returns tables for display: joints with their limits, couplings, frames, tips, centres, remarks.
std::string robot_text(const robot::RobotDescription& description);
/// Returns the same data as JSON, in SI units.
std::string robot_json(const robot::RobotDescription& description);

}  // namespace morphe::describe
