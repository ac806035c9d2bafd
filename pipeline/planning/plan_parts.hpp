#pragma once

#include <vector>

#include "pipeline/planning/parts_options.hpp"
#include "pipeline/planning/plan_movement.hpp"

namespace morphe::planning {

/// The movement's plan; one that fails after it was mapped is cut into halves, each planned by
/// itself with the base where it was, and so on until a part succeeds or would be cut below
/// least_s. All parts in order of time, none left out: those that fail carry their reasons. Each
/// executable one is at rest where it begins and ends.
std::vector<Plan> plan_parts(const Planner& planner, const Demonstration& demonstration,
                             const HumanMotion& recorded, const Movement& movement,
                             const PartsOptions& options, StageSeconds& seconds);

}  // namespace morphe::planning
