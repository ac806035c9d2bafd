#pragma once

#include <string>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::explain {

/// Returns a summary of the plan by stages: lines of text, indented below the plan's name and
/// status. Advice is not included.
std::string step_summary(const RobotModel& robot, const Plan& plan);

}  // namespace morphe::explain
