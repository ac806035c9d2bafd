#pragma once

#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "pipeline/planning/run_config.hpp"

namespace morphe::explain {

/// Plans the plan's movement again from its recording, with KEY=VALUE settings in addition to the
/// run's config. Throws InputError for invalid settings.
Plan replan(const planning::RunConfig& config, const Demonstration& demonstration, const Plan& plan,
            const std::vector<std::string>& settings);

}  // namespace morphe::explain
