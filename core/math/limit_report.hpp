#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::math {

/// The largest |value| / limit over joints and time; for the velocity, also of braking curves.
struct LimitUse {
  double ratio = 0;
  int sample = -1, joint = -1;  ///< the sample before the maximum; -1 for an empty trajectory
};
/// The use of all limits by a trajectory.
struct LimitReport {
  LimitUse velocity, acceleration, jerk;
  double position_margin = kUnknown;  ///< smallest distance to a limit, < 0 if exceeded [rad]
  int margin_sample = -1, margin_joint = -1;
};
/// Computes the use of all limits by a trajectory: by the quintics between its samples.
LimitReport limit_report(const RobotModel& robot, const Trajectory& trajectory);

/// The use of limits by the cubic Hermite pieces between samples. Their acceleration jumps at the
/// samples, so that they have no finite jerk there.
struct CubicLimitReport {
  LimitUse velocity, acceleration;
};
/// Computes the use of limits by a controller that interpolates positions and velocities.
CubicLimitReport cubic_limit_report(const RobotModel& robot, const Trajectory& trajectory);

}  // namespace morphe::math
