#pragma once

#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::report {

/// Selects the rows of a trajectory to be displayed, in order: the first, the last, one at least
/// every 1 / rate_hz seconds if the samples are that dense, and the rows with the extreme values of
/// the whole trajectory: greatest velocity, acceleration and jerk (up to the next row) of each
/// joint, its least and greatest position, and the least clearance.
std::vector<int> select_display_rows(const RobotModel& robot, const Trajectory& trajectory,
                                     double rate_hz);

/// Computes, for each joint, the jerk that is greatest in magnitude up to the next row [T - 1, n],
/// as a signed ratio to its limit.
JointRows jerk_ratios(const RobotModel& robot, const Trajectory& trajectory);

}  // namespace morphe::report
