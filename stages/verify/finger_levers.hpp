#pragma once

#include "core/motion/robot_table.hpp"

namespace morphe::verify {

/// How a point that is fixed to a frame moves with the joints of the fingers, which are those that
/// do not move the palm: [3, n] in the base frame, by central differences [m/rad]. Columns of other
/// joints are 0. Its transpose makes torques of a force at the point.
Eigen::Matrix3Xd finger_levers(const RobotTable& robot, const JointVector& q, int frame,
                               const Vec3& point_in_base);

}  // namespace morphe::verify
