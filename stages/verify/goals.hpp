#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/verify/violation_log.hpp"

namespace morphe::verify {

/// Records `goals` violations if a plan with a trajectory has goals that a person's movement cannot
/// produce:
/// time             fewer than 5 frames (value: their number); not evenly spaced to 1e-6 s; the
///                  first frame is a step or more away from the movement's begin, or the last from
///                  its end [s]
/// tip_position     no tip has a goal in any frame, or in any frame within a phase grasp or hold;
///                  only some of a goal's coordinates are known
/// tip_orientation, wrist_orientation   neither a unit quaternion nor unseen
/// reachable        neither 0 nor 1; or 1 though the goal is farther from the base than all links
///                  together are long, plus 0.1 m if goals may apply to pads [m]
/// Which tips the person's recording did not show cannot be determined from the plan.
void verify_goals(const RobotModel& robot, const Plan& plan, ViolationLog& violations);

}  // namespace morphe::verify
