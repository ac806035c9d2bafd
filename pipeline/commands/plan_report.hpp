#pragma once

#include <string>

#include "core/motion/robot_table.hpp"
#include "pipeline/run/batch.hpp"

namespace morphe::commands {

/// Below a run's table: how much of the placement's goals the robot reaches, and what of the robot
/// is not checked. Without a newline at the end.
std::string plan_table_foot(const RobotTable& robot, const run::BatchSummary& summary);

}  // namespace morphe::commands
