#pragma once

#include "core/motion/demonstration.hpp"
#include "core/motion/outcome.hpp"
#include "core/motion/plan.hpp"

namespace morphe::planning {

/// Returns a plan that contains only its demonstration's names, its movement and its tolerances.
Plan begin_plan(const Demonstration& demonstration, const Movement& movement,
                const Tolerances& tolerances);

/// Returns the plan as a failed one: with the reason, without trajectory, approach and retreat, and
/// without the grasp and the certificate of the trajectory.
Plan fail(Plan plan, PlanningFailure failure);

}  // namespace morphe::planning
