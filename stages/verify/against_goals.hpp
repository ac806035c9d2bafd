#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::verify {

/// A trajectory's samples against the goals at their demonstration times. NaN: nothing to compare.
struct AgainstGoals {
  double position_max = kNotSeen, position_mean = kNotSeen;    ///< tips from their goals [m]
  double position_grasp = kNotSeen;                            ///< the largest in grasp and hold
  double orientation_max = kNotSeen;                           ///< full angle [rad]
  double upper_arm_max = kNotSeen, upper_arm_mean = kNotSeen;  ///< angle of the directions [rad]
  double humanlikeness = kNotSeen;  ///< mean over samples of sum over the arm's centres of
                                    ///< |human elbow - centre|^2 [m^2]
};
AgainstGoals against_goals(const RobotTable& robot, const Plan& plan);

}  // namespace morphe::verify
