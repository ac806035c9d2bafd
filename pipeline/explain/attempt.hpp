#pragma once

#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "pipeline/planning/run_config.hpp"

namespace morphe::explain {

/// The plan's movement, planned again from its recording with KEY=VALUE settings that the run with
/// this config did not have. InputError for what the config cannot have.
Plan plan_again(const planning::RunConfig& config, const Demonstration& demonstration,
                const Plan& plan, const std::vector<std::string>& settings);

}  // namespace morphe::explain
