#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::verify {

/// Errors of a trajectory's samples against the goals at their demonstration times. NaN if there is
/// no goal to compare with.
struct GoalErrors {
  double position_max = kUnknown, position_mean = kUnknown;  ///< of the tips [m]
  double position_grasp = kUnknown;                          ///< largest in grasp and hold [m]
  double orientation_max = kUnknown;                         ///< angle of rotation [rad]
  /// Angle between the directions of the human's and the robot's upper arm [rad].
  double upper_arm_max = kUnknown, upper_arm_mean = kUnknown;
  double humanlikeness = kUnknown;  ///< metric A, mean over samples [m^2]
};
/// Computes the errors of the plan's trajectory.
GoalErrors goal_errors(const RobotModel& robot, const Plan& plan);

/// Interpolates unit quaternions (x, y, z, w) along the shorter way: `share` of it, from 0 to 1.
Eigen::Vector4d slerp(const Eigen::Vector4d& from, Eigen::Vector4d to, double share);

/// Returns the angle of the rotation between a pose's and a unit quaternion (x, y, z, w) [rad]:
/// 4 asin(|difference of the quaternions| / 2), with the sign that makes the difference smaller.
double rotation_angle(const Pose& pose, const Eigen::Vector4d& goal);

/// Computes metric A of humanlikeness: the sum over the arm's joint centres of |human elbow -
/// centre|^2 [m^2]; 0 for a robot without such centres.
double squared_elbow_distances(const RobotModel& robot, const std::vector<Pose>& base_from_frame,
                               const Vec3& elbow);

}  // namespace morphe::verify
