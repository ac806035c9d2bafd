#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/verify/violation_collector.hpp"

namespace morphe::verify {

/// Records `status` violations for a plan with a trajectory that is marked executable although a
/// larger share of its goals is out of reach than it allows, or a tip is farther from its goal at a
/// sample than it allows; and for a plan that is marked approximate although neither holds. The
/// reachability is taken from the file. Files that do not state the allowed values are skipped.
void verify_status(const RobotModel& robot, const Plan& plan, ViolationCollector& runs);

}  // namespace morphe::verify
