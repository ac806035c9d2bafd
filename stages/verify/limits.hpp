#pragma once

#include "core/motion/robot_model.hpp"
#include "stages/verify/curve.hpp"
#include "stages/verify/violation_collector.hpp"

namespace morphe::verify {

/// The use of the robot's limits by a curve: the least distance to a position limit [rad] and the
/// largest |value| / limit of each derivative.
struct LimitUse {
  double position_margin = 0;
  double velocity_ratio = 0, acceleration_ratio = 0, jerk_ratio = 0;
};

/// Records `position`, `velocity`, `acceleration` and `jerk` violations for each joint if the
/// quintic exceeds the joint's limits by more than 1e-6 of them (position: of the joint's range),
/// for each coupled frame that exceeds its own limits (by its name), and `velocity` violations if a
/// joint is faster than its braking curve allows. Returns the use of the limits.
LimitUse verify_limits(const RobotModel& robot, const Curve& curve, ViolationCollector& runs);

/// Records `rest` violations for each joint whose velocity or acceleration exceeds 1e-9 at either
/// end of the trajectory.
void verify_rest(const RobotModel& robot, const Trajectory& trajectory, ViolationCollector& runs);

}  // namespace morphe::verify
