#pragma once

#include <random>

#include "core/motion/robot_model.hpp"

namespace morphe {

/// A position inside the middle `share` of each joint's range.
inline JointVector random_position(const RobotModel& robot, std::mt19937_64& random,
                                   double share = 1) {
  JointVector q(robot.lower.size());
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const double centre = 0.5 * (robot.lower[j] + robot.upper[j]);
    const double half = 0.5 * share * (robot.upper[j] - robot.lower[j]);
    q[j] = centre + half * (2 * static_cast<double>(random() >> 11) * 0x1p-53 - 1);
  }
  return q;
}

}  // namespace morphe
