#pragma once

#include <string>
#include <vector>

#include "stages/simulate/ensemble.hpp"

namespace morphe::commands {

/// Returns a table with one row per plan: the number of its rollouts in which the grasp held, the
/// largest or median figures, and the causes of the failures; then a summary and the assumptions.
std::string simulation_table(const std::vector<simulate::PlanResult>& results,
                             const simulate::SimulateOptions& options, std::size_t width);

/// Returns the JSON that `simulate --json` prints (docs/formats.md).
std::string simulation_json(const std::vector<simulate::PlanResult>& results);

}  // namespace morphe::commands
