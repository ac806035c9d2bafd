#pragma once

#include <string>

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::explain {

/// What became of a movement, step by step, from what its plan holds: lines of text, indented below
/// the plan's name and status. Without what to try.
std::string story_of(const RobotTable& robot, const Plan& plan);

}  // namespace morphe::explain
