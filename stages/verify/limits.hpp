#pragma once

#include "core/motion/robot_model.hpp"
#include "stages/verify/curve.hpp"
#include "stages/verify/violation_log.hpp"

namespace morphe::verify {

/// The use of the robot's limits by a curve: the least distance to a position limit [rad or m] and
/// the largest |value| / limit of each derivative.
struct LimitUse {
  double position_margin = 0, velocity_ratio = 0, acceleration_ratio = 0, jerk_ratio = 0;
};

/// Records `position`, `velocity`, `acceleration` and `jerk` violations along the quintics of a
/// curve for each joint that exceeds its limits by more than 1e-6 of them (position: of its range),
/// and for each coupled frame that exceeds its own, under the frame's name. Records `velocity`
/// violations for joints faster than their braking curves allow. Returns the use of joint limits.
LimitUse verify_limits(const RobotModel& robot, const Curve& curve, ViolationLog& violations);

/// Records `rest` violations for each joint whose velocity or acceleration exceeds 1e-9 at either
/// end of the trajectory.
void verify_rest(const RobotModel& robot, const Curve& curve, ViolationLog& violations);

}  // namespace morphe::verify
