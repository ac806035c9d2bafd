#pragma once

#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "pipeline/planning/run_config.hpp"

namespace morphe::explain {

/// Plans the movement again, with further KEY=VALUE settings. For a plan without a movement, plans
/// the first one found now, if any, or returns `plan`. Throws InputError for invalid settings.
Plan replan(const planning::RunConfig& config, const Demonstration& demonstration, const Plan& plan,
            const std::vector<std::string>& settings);

}  // namespace morphe::explain
