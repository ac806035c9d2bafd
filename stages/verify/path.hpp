#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/verify/violation_log.hpp"

namespace morphe::verify {

/// Records `path` violations for a path that does not lead from the mapped frames to the
/// trajectory:
/// demonstration_time  decreases, or does not begin and end with the goals; 1e-9 s
/// position            not finite; or a sample of origin mapped differs from the mapped position at
///                     its time; 1e-9 rad
/// trajectory          a joint of a sample is more than 0.2 rad (prismatic: 0.1 m) outside of its
///                     range in the path's samples at that time and next to it; smoothing changes
///                     far less
/// origin              a sample of the trajectory has an origin that these samples do not have
void verify_path(const RobotModel& robot, const Plan& plan, ViolationLog& violations);

}  // namespace morphe::verify
