#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/verify/violation_collector.hpp"

namespace morphe::verify {

/// Records `path` violations for a path that does not lead from the mapped frames to the
/// trajectory:
/// demonstration_time  decreases, or does not begin and end with the goals; 1e-9 s
/// position            not finite; or of origin mapped, and different from the mapped position at
///                     its time; 1e-9 rad
/// trajectory          a sample is more than 0.2 rad (0.1 m for a prismatic joint) outside of the
///                     path's range around its time; smoothing stays far within this tolerance
/// origin              a sample of the trajectory has an origin that the path does not have around
///                     its time
void verify_path(const RobotModel& robot, const Plan& plan, ViolationCollector& runs);

}  // namespace morphe::verify
