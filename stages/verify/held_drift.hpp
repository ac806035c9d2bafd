#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::verify {

/// Sets held_drift [m] and held_turn [rad] of `own`: by how much a pad that touches the target is
/// displaced and turned in the palm's frame, at most, between the grasp's sample and any later one
/// up to the end of the last transport. They stay unknown if no transport begins before the plan's
/// end, or without a touching pad.
void recompute_held_drift(const RobotModel& robot, const Plan& plan, Certificate& own);

}  // namespace morphe::verify
