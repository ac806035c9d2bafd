#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/verify/violation_collector.hpp"

namespace morphe::verify {

/// Records `goals` violations if a plan with a trajectory has goals that a person's movement cannot
/// produce:
/// time             fewer than 5 frames (value: their number); not evenly spaced to 1e-6 s; the
///                  first or the last frame is a step or more away from the movement's begin or
///                  end; s
/// tip_position     no tip has a goal; no tip has one while a phase grasp or hold is planned; only
///                  some of a goal's coordinates are known
/// tip_orientation  neither a unit quaternion nor unseen; the same for wrist_orientation
/// reachable        neither 0 nor 1; marked reachable though farther from the base than the length
///                  of all links together; m
/// The tips that a person's recording did not show cannot be determined from the plan.
void verify_goals(const RobotModel& robot, const Plan& plan, ViolationCollector& runs);

}  // namespace morphe::verify
