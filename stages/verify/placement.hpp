#pragma once

#include "core/motion/plan_request.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/verify/violation_log.hpp"

namespace morphe::verify {

/// Records `config` violations if the placement of a plan is not the request's, to 1e-6 m or entry:
/// reference_frames/recording  the rotation of the base in the world, or the pose of a hand alone
/// reference_frames/shoulder   the person's shoulder at the movement's begin
/// common_base_offset          translation of the human arm, such that its shoulder is the robot's
/// base_offset                 present though not requested, absent, or beyond its limit
/// goals/shoulder_position     the first one that is known is not the robot's shoulder
void verify_placement(const RobotModel& robot, const Plan& plan, const PlanRequest& request,
                      ViolationLog& violations);

}  // namespace morphe::verify
