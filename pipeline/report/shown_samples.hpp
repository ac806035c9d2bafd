#pragma once

#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::report {

/// Rows of a trajectory to be shown, in order: the first, the last, one at least every 1 / rate_hz
/// seconds if there are as many, and those where a joint's velocity, acceleration or jerk (up to
/// the next row), a position's nearness to its limit or the least clearance is what the whole
/// trajectory has at most.
std::vector<int> shown_samples(const RobotTable& robot, const Trajectory& trajectory,
                               double rate_hz);

/// [T - 1, n] of each joint the jerk that is greatest in size up to the next row, as a share of its
/// limit, signed.
JointRows jerk_shares(const RobotTable& robot, const Trajectory& trajectory);

}  // namespace morphe::report
