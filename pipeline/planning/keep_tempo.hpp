#pragma once

#include "pipeline/planning/place_movement.hpp"

namespace morphe::planning {

/// Lets a plan with a free path keep the person's tempo as `repair.tempo` asks: while the robot's
/// limits make the trajectory take longer than max_duration_ratio times the person's time, the path
/// is solved again with more cost of motion, which rounds off what the robot cannot follow, such as
/// the tremor of tracked keypoints. The last path is kept that is free and
/// whose tips are off by at most max_tip_error_ratio times as much, in the mean, as those of the
/// mapped or of the given path, whichever are farther. The attempts are appended to `plan.repair`.
/// `world` has the whole scene. Without `repair.tempo` the plan is returned unchanged.
Plan keep_tempo(const PlanningInputs& planner, const PlacedMovement& placed,
                const collision::CollisionWorld& world, Plan plan);

}  // namespace morphe::planning
