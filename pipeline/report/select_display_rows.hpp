#pragma once

#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::report {

/// Returns the rows of a trajectory to be displayed, in order:
///   - the first and the last
///   - one at least every 1 / rate_hz seconds, as far as the samples are that dense
///   - for each joint, those with the greatest |velocity|, |acceleration| and |jerk| until the next
///     row, and with the least and the greatest position
///   - that with the least clearance
std::vector<int> select_display_rows(const RobotModel& robot, const Trajectory& trajectory,
                                     double rate_hz);

/// Returns the jerk of greatest magnitude until the next row, as a signed ratio to its limit [T -
/// 1, n].
JointRows jerk_ratios(const RobotModel& robot, const Trajectory& trajectory);

}  // namespace morphe::report
