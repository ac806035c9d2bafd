#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/verify/violation_log.hpp"

namespace morphe::verify {

/// Records `status` violations of a plan with a trajectory. It must be marked approximate, and not
/// executable, exactly if
///   - more of its goals are out of reach than max_unreachable_share, or all are
///   - a tip is farther from its goal at a sample than max_tip_error
///   - a larger share of the goals of a phase is missing than max_missing_goal_share
///   - there is no goal for longer than max_goal_gap_s
/// The reachability is taken from the file; goals of automatically closed fingers do not count.
/// Skipped for files of earlier versions, without the first two values.
void verify_status(const RobotModel& robot, const Plan& plan, ViolationLog& violations);

}  // namespace morphe::verify
