#pragma once

#include <string>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::explain {

/// Returns the plan's name and status, and below them lines on the results of each stage.
std::string step_summary(const RobotModel& robot, const Plan& plan);

}  // namespace morphe::explain
