#pragma once

#include <cstdint>

#include "core/motion/outcome.hpp"
#include "core/motion/plan.hpp"
#include "pipeline/planning/approach_options.hpp"
#include "pipeline/planning/planner.hpp"

namespace morphe::planning {

/// Returns the home posture of all joints. The joints named in the options must be the robot's.
JointVector home_posture(const RobotModel& robot, const ApproachOptions& options);

/// Plans, times and certifies the approach of an executable plan from home to its first sample, and
/// the retreat from its last one, in the plan's scene as it is at these times. Refuses with
/// no_approach or no_retreat if there is no such path. The retreat starts by releasing: objects
/// that the hand touches may be touched on the way; if no other path is found, the retreat reverses
/// the plan's motion. If the target is attached at the end there is no retreat, because it would
/// have to be carried home.
PlanningFailure add_approach(const PlanningInputs& planner, const ApproachOptions& options,
                             std::uint64_t seed, Plan& plan);

}  // namespace morphe::planning
