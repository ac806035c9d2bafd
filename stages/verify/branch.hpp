#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/verify/violation_log.hpp"

namespace morphe::verify {

/// Records a `branch` violation for shoulder, elbow or wrist if the stored number of the plan's
/// branch contradicts the postures of its trajectory; value and limit are 1 for left, negative and
/// flipped, 0 for right, positive and unflipped: as stored, and as recomputed.
void verify_branch(const RobotModel& robot, const Plan& plan, ViolationLog& violations);

}  // namespace morphe::verify
