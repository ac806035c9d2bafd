#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/verify/violation_log.hpp"

namespace morphe::verify {

/// Records `mapped` violations, one for each column with the values of its worst frame:
/// tip_error, tip_orientation_error, humanlikeness (metric A)   not that of the mapped posture and
///           its goals; 1e-6 max(1, value)
/// status    does not follow from the tips within 1 mm of their goals and the stored reachability
/// position  frames are missing, or values are not finite
/// objective  not finite; its value, and metrics B and C, are not compared
void verify_mapping(const RobotModel& robot, const Plan& plan, ViolationLog& violations);

}  // namespace morphe::verify
