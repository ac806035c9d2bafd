#pragma once

#include <string>

#include "pipeline/motion/plan.hpp"
#include "pipeline/run/batch.hpp"

namespace morphe::commands {

/// What a person wants to see of each plan after a run: a row per plan, a line of explanation for
/// those that are infeasible, and how much of the placement's goals the robot reaches. Without a
/// newline at the end.
std::string plan_table_head();
std::string plan_rows(const Plan& plan);
std::string plan_table_foot(const std::string& robot, const run::BatchSummary& summary);

}  // namespace morphe::commands
