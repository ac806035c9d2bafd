#pragma once

#include <string>
#include <vector>

#include "stages/simulate/ensemble.hpp"

namespace morphe::commands {

/// A row a plan: how many of its rollouts held, the largest or median figures, the causes of the
/// others; then a summary and what was assumed.
std::string simulation_table(const std::vector<simulate::PlanResult>& results,
                             const simulate::SimulateOptions& options, std::size_t width);

/// What `simulate --json` prints (docs/formats.md).
std::string simulation_json(const std::vector<simulate::PlanResult>& results);

}  // namespace morphe::commands
