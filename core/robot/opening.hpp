#pragma once

#include "core/motion/robot_model.hpp"

namespace morphe::robot {

/// Returns the largest distance between the tips of thumb and index within the joint limits [m],
/// NaN without both. It is searched joint by joint, from rest and from both ends of all ranges:
/// exact for a gripper of one joint up to the steps of a fortieth of its range, a lower bound for a
/// hand. The search ends when `enough_m` is reached.
double widest_opening(const RobotModel& robot, double enough_m = kInfinity);

}  // namespace morphe::robot
