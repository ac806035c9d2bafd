#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::verify {

/// Errors of a trajectory's samples against the goals at their demonstration times. NaN if there is
/// no goal to compare with.
struct GoalErrors {
  /// distance of the tips from their goals [m]
  double position_max = kUnknown, position_mean = kUnknown;
  double position_grasp = kUnknown;   ///< largest error in grasp and hold
  double orientation_max = kUnknown;  ///< angle of rotation [rad]
  /// angle between the directions [rad]
  double upper_arm_max = kUnknown, upper_arm_mean = kUnknown;
  /// mean over samples of the sum over the arm's centres of |human elbow - centre|^2 [m^2]
  double humanlikeness = kUnknown;
};
/// Computes the errors of the plan's trajectory.
GoalErrors goal_errors(const RobotModel& robot, const Plan& plan);

}  // namespace morphe::verify
