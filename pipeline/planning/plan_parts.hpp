#pragma once

#include <vector>

#include "pipeline/planning/parts_options.hpp"
#include "pipeline/planning/plan_movement.hpp"

namespace morphe::planning {

/// Plans a movement in parts. A movement that fails after the mapping is divided into halves, which
/// are planned separately with the same base position, and divided again if they fail. A part
/// shorter than 2 · min_duration_s is not divided. Returns all parts in temporal order; failed ones
/// contain their reasons. Each executable part begins and ends at rest.
std::vector<Plan> plan_parts(const PlanningInputs& planner, const Demonstration& demonstration,
                             const HumanMotion& recorded, const Movement& movement,
                             const PartsOptions& options);

}  // namespace morphe::planning
