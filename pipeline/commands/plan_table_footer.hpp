#pragma once

#include <string>

#include "core/motion/robot_model.hpp"
#include "pipeline/run/batch.hpp"

namespace morphe::commands {

/// Returns the lines below the table of a run: the share of the placement's goals that the robot
/// reaches, and the parts of the robot that are not checked for collisions. There is no newline at
/// the end.
std::string plan_table_footer(const RobotModel& robot, const run::BatchSummary& summary);

}  // namespace morphe::commands
