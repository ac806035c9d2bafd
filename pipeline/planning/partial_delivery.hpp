#pragma once

#include <vector>

#include "pipeline/planning/plan_movement.hpp"

namespace morphe::planning {

/// Returns the phases after which a plan of a movement may be cut: those that may end a plan and
/// end before the movement does, the latest first. Those that end while the hand holds its target
/// in the air are among them with `in_air` only. Without a grasp they are the reaches.
std::vector<Phase> permitted_cuts(const Movement& movement, PartialPlans partial);

/// Plans a movement. If that fails although parts of it may hold, plans the longest part that is
/// executable, up to a permitted cut (key segment.partial) and with the same position of the base.
/// All cuts are tried, the latest first: findings that are left of the whole do not tell which of
/// them a shorter plan would have, because repair stops at one that it cannot remove. The plan of a
/// part has the status partial, the reason of the failure, and a detail that says how far it is
/// delivered. If no part is executable, returns the failed plan.
Plan plan_movement_or_part(const PlanningInputs& planner, const Demonstration& demonstration,
                           const HumanMotion& recorded, const Movement& movement);

}  // namespace morphe::planning
