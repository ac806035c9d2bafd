#pragma once

#include <cstdint>

#include "core/motion/outcome.hpp"
#include "core/motion/plan.hpp"
#include "pipeline/planning/approach_options.hpp"
#include "pipeline/planning/planner.hpp"

namespace morphe::planning {

/// Returns the home posture, moved into the limits. The joints in `options` must be the robot's.
JointVector home_posture(const RobotModel& robot, const ApproachOptions& options);

/// Adds to an executable plan its approach, from home to the first sample, and its retreat, from
/// the last sample to home. Each is planned, timed and certified in the scene at that sample. The
/// retreat may touch objects that the hand touches at its start; if no other is found, it is the
/// plan's motion and its approach, reversed. Refuses with no_approach or no_retreat; with
/// no_retreat also if the target is attached at the end, because it would have to be carried home.
PlanningFailure add_approach(const PlanningInputs& planner, const ApproachOptions& options,
                             std::uint64_t seed, Plan& plan);

}  // namespace morphe::planning
