#pragma once

#include <string>
#include <vector>

#include "stages/simulate/ensemble.hpp"

namespace morphe::commands {

/// Returns a table with one row per plan: the number of its rollouts in which the target was held,
/// figures over its rollouts, and the causes of failures; below it, the assumptions and a summary.
std::string simulation_table(const std::vector<simulate::PlanResult>& results,
                             const simulate::SimulateOptions& options, std::size_t width);

/// Returns the JSON that `simulate --json` prints (docs/formats.md).
std::string simulation_json(const std::vector<simulate::PlanResult>& results);

}  // namespace morphe::commands
