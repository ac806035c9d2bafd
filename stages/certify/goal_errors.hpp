#pragma once

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"

namespace morphe::certify {

/// Where a trajectory's tips and upper arm are, against the goals at each sample's demonstration
/// time. NaN = nothing to compare.
struct GoalErrors {
  double position_max = kNotSeen, position_mean = kNotSeen;    ///< all tips with goals [m]
  double position_grasp = kNotSeen;                            ///< largest in grasp and hold [m]
  double orientation_max = kNotSeen;                           ///< full angle [rad]
  double upper_arm_max = kNotSeen, upper_arm_mean = kNotSeen;  ///< between directions [rad]
  double humanlikeness = kNotSeen;  ///< mean of metric A's sum over the arm's centres [m^2]
  /// The tip farthest beyond what is tolerated; excess <= 0: none is.
  double worst_excess = kNotSeen, worst_error = kNotSeen, worst_tolerance = kNotSeen;
  int worst_sample = -1, worst_tip = -1;
};
GoalErrors goal_errors(const robot::Robot& robot, const Goals& goals, const Movement& movement,
                       const Tolerances& tolerances, const Trajectory& trajectory);

/// The tip farthest beyond what is tolerated between samples that are more than 2 ms apart, on the
/// quintic that a controller runs, looked at every 2 ms at least; sample: the one before it.
/// Samples that are not farther apart speak for what is between them.
struct TipBetween {
  double excess = kNotSeen, error = kNotSeen, tolerance = kNotSeen;  ///< [m]; NaN: none was seen
  double time_s = 0;                                                 ///< of the trajectory
  int sample = -1, tip = -1;
};
TipBetween farthest_between(const robot::Robot& robot, const Goals& goals, const Movement& movement,
                            const Tolerances& tolerances, const Trajectory& trajectory);

}  // namespace morphe::certify
