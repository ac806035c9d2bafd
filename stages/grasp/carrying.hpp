#pragma once

#include "core/motion/outcome.hpp"
#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"

namespace morphe::grasp {

/// Returns true if a movement carries its target and the robot has pads on several fingers: two
/// opposed contacts must then hold the target.
bool must_be_held(const robot::Robot& robot, const Movement& movement);

/// Returns true if the touching contacts of an evaluated grasp hold the target: two of them are
/// opposed (closure::are_opposed), or all together have force closure (epsilon_lower > 0).
bool is_held(const Grasp& grasp);

/// Returns the failure not_held if the target must be held, but the grasp does not hold it, or the
/// pads move in the hand by more than kMaxHeldDrift_m or kMaxHeldTurn_rad until the release. Its
/// detail names the contacts and their state, or the motion.
PlanningFailure check_held(const robot::Robot& robot, const Plan& plan);

}  // namespace morphe::grasp
