#pragma once

#include <string>

#include "pipeline/motion/plan.hpp"
#include "pipeline/motion/robot_table.hpp"
#include "pipeline/run/batch.hpp"
#include "stages/place/stand.hpp"

namespace morphe::commands {

/// What a person wants to see of each plan after a run: a row per plan, a line of explanation for
/// those that are infeasible, how much of the placement's goals the robot reaches, and what of the
/// robot is not checked. Without a newline at the end.
std::string plan_table_head();
std::string plan_rows(const RobotTable& robot, const Plan& plan);
/// Where the base stands, relative to the person and, as in `plan`, to the table; "" of a hand
/// alone.
std::string base_sentence(const RobotTable& robot, const map::PlacementOptions& placement,
                          const Plan& plan);
std::string plan_table_foot(const RobotTable& robot, const run::BatchSummary& summary);

}  // namespace morphe::commands
