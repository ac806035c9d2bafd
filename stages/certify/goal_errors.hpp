#pragma once

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"

namespace morphe::certify {

/// Errors of a trajectory's tips and upper arm against the goals at each sample's demonstration
/// time. NaN if there is no goal to compare with.
struct GoalErrors {
  double position_max = kUnknown, position_mean = kUnknown;  ///< over all tips with goals [m]
  double position_grasp = kUnknown;                          ///< largest in grasp and hold [m]
  double orientation_max = kUnknown;                         ///< angle of rotation [rad]
  /// angle between the directions [rad]
  double upper_arm_max = kUnknown, upper_arm_mean = kUnknown;
  double humanlikeness = kUnknown;  ///< mean of metric A's sum over the arm's centres [m^2]
  /// the tip that exceeds its tolerance by most; excess <= 0 if all are within tolerance
  double worst_excess = kUnknown, worst_error = kUnknown, worst_tolerance = kUnknown;
  int worst_sample = -1, worst_tip = -1;
};
/// Computes the errors of a trajectory at its samples.
GoalErrors goal_errors(const robot::Robot& robot, const Goals& goals, const Movement& movement,
                       const Tolerances& tolerances, const Trajectory& trajectory);

/// The tip that exceeds its tolerance by most between samples that are more than 2 ms apart, on the
/// quintic that a controller executes, evaluated at least every 2 ms; sample is the one before it.
/// For samples that are closer, the samples themselves represent the motion between them.
struct InterSampleTipError {
  /// [m]; NaN if no interval was evaluated
  double excess = kUnknown, error = kUnknown, tolerance = kUnknown;
  double time_s = 0;  ///< time on the trajectory's clock
  int sample = -1, tip = -1;
};
/// Computes the worst error between samples.
InterSampleTipError worst_inter_sample_error(const robot::Robot& robot, const Goals& goals,
                                             const Movement& movement, const Tolerances& tolerances,
                                             const Trajectory& trajectory);

}  // namespace morphe::certify
