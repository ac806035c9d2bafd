#pragma once

#include "core/motion/outcome.hpp"
#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"

namespace morphe::grasp {

/// Returns the time at which a movement begins to carry its target: the begin of its first
/// transport in the planned interval; NaN if the target is not carried, or if there is no target.
double carrying_begin_s(const Movement& movement);

/// Returns true if the touching contacts of an evaluated grasp hold the target: two of them are
/// opposed (closure::are_opposed), or all together have force closure (epsilon_lower > 0).
bool is_held(const Grasp& grasp);

/// Returns the failure not_held if the movement carries its target, the robot has pads on several
/// fingers, and the grasp does not hold the target. Its detail names the contacts and their state.
PlanningFailure check_held(const robot::Robot& robot, const Movement& movement, const Grasp& grasp);

}  // namespace morphe::grasp
