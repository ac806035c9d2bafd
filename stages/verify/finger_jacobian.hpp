#pragma once

#include "core/motion/robot_model.hpp"

namespace morphe::verify {

/// Computes the Jacobian of a point fixed to a frame with respect to the finger joints, which are
/// the joints that do not move the palm: [3, n] in the base frame, by central differences [m/rad].
/// Columns of all other joints are 0. Its transpose maps a force at the point to joint torques.
Eigen::Matrix3Xd finger_jacobian(const RobotModel& robot, const JointVector& q, int frame,
                                 const Vec3& point_in_base);

}  // namespace morphe::verify
