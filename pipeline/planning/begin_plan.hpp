#pragma once

#include "core/motion/demonstration.hpp"
#include "core/motion/outcome.hpp"
#include "core/motion/plan.hpp"

namespace morphe::planning {

/// Returns a plan that only identifies its demonstration and movement.
Plan begin_plan(const Demonstration& demonstration, const Movement& movement,
                const Tolerances& tolerances);

/// Returns the plan as a failed one, with its reason and without a trajectory.
Plan fail(Plan plan, PlanningFailure failure);

}  // namespace morphe::planning
