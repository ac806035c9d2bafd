#pragma once

#include "core/motion/robot_table.hpp"
#include "stages/verify/curve.hpp"
#include "stages/verify/violation_runs.hpp"

namespace morphe::verify {

/// What the curve makes of the robot's limits: the least distance to a position limit [rad] and
/// the largest |value| / limit of each derivative.
struct LimitUse {
  double position_margin = 0;
  double velocity_ratio = 0, acceleration_ratio = 0, jerk_ratio = 0;
};

/// Notes `position`, `velocity`, `acceleration` and `jerk` for each joint wherever the quintic
/// leaves its limits by more than 1e-6 of them (position: of the joint's range), for each coupled
/// frame where that leaves its own (by its name), and `velocity` where a joint is faster than its
/// braking curve leaves it.
LimitUse judge_limits(const RobotTable& robot, const Curve& curve, ViolationRuns& runs);

/// Notes `rest` for each joint whose velocity or acceleration exceeds 1e-9 at an end.
void judge_rest(const RobotTable& robot, const Trajectory& trajectory, ViolationRuns& runs);

}  // namespace morphe::verify
