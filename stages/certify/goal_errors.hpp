#pragma once

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"

namespace morphe::certify {

/// Errors of tips and upper arm against the goals at the demonstration times; NaN without goals.
struct GoalErrors {
  double position_max = kUnknown, position_mean = kUnknown;    ///< over all tips with goals [m]
  double position_grasp = kUnknown;                            ///< largest in grasp and hold [m]
  double orientation_max = kUnknown;                           ///< angle of rotation [rad]
  double upper_arm_max = kUnknown, upper_arm_mean = kUnknown;  ///< angle between directions [rad]
  double humanlikeness = kUnknown;  ///< mean of metric A's sum over the arm's centres [m^2]
  /// values of the tip that exceeds its tolerance by most [m]; excess <= 0 if all are within it
  double worst_excess = kUnknown, worst_error = kUnknown, worst_tolerance = kUnknown;
  int worst_sample = -1, worst_tip = -1;
};
/// Returns the angle between the robot's upper arm, from its shoulder frame to the first joint
/// centre, and the person's at a demonstration time [rad]; NaN if one of them is unknown.
double upper_arm_error(const robot::Robot& robot, const std::vector<Pose>& base_from_frame,
                       const Goals& goals, double time_s);

/// Computes the errors of a trajectory at its samples.
GoalErrors goal_errors(const robot::Robot& robot, const Goals& goals, const Movement& movement,
                       const Tolerances& tolerances, const Trajectory& trajectory);

/// The error of the tip that exceeds its tolerance by most, on the quintics that a controller
/// executes between samples that are more than 2 ms apart, evaluated at least every 2 ms.
struct InterSampleTipError {
  double excess = kUnknown, error = kUnknown, tolerance = kUnknown;  ///< [m]; NaN if not evaluated
  double time_s = 0;  ///< time on the trajectory's clock
  int sample = -1;    ///< the sample before that time
  int tip = -1;
};
/// Computes the worst error between samples.
InterSampleTipError worst_inter_sample_error(const robot::Robot& robot, const Goals& goals,
                                             const Movement& movement, const Tolerances& tolerances,
                                             const Trajectory& trajectory);

}  // namespace morphe::certify
