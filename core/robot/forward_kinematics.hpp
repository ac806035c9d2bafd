#pragma once

#include <vector>

#include "core/motion/robot_model.hpp"

namespace morphe::robot {

/// Computes base_from_frame = base_from_parent * transform * Rotation(axis, ratio * q[joint] +
/// offset), or a translation along the axis for prismatic joints, for all frames of the robot in
/// one pass, parents first. `base_from_frame` is resized once and can be reused. q [n] [rad or m].
void forward_kinematics(const RobotModel& robot, const Eigen::Ref<const JointVector>& q,
                        std::vector<Pose>& base_from_frame);

/// Returns base_from_tip of one tip, given the poses of the frames.
Pose tip_pose(const RobotModel& robot, const std::vector<Pose>& base_from_frame, std::size_t tip);

/// Computes the Jacobian d point / d q of a point that moves with `frame` (-1 = base: zero), in the
/// base frame [m/rad], or [m/m] for prismatic joints. A coupled joint adds ratio times its column
/// to the joint that drives it. jacobian [3, n] is overwritten.
void point_jacobian(const RobotModel& robot, const std::vector<Pose>& base_from_frame, int frame,
                    const Vec3& point_in_base, Eigen::Ref<Eigen::Matrix3Xd> jacobian);

/// Adds direction · d point / d q of a point that moves with `frame` to slope [n], for the joints
/// between `ancestor` (exclusive; -1 = the base: all joints) and `frame`.
void add_point_gradient(const RobotModel& robot, const std::vector<Pose>& base_from_frame,
                        int frame, int ancestor, const Vec3& point_in_base, const Vec3& direction,
                        Eigen::Ref<JointVector> slope);

/// Computes the position and rotation Jacobians of all tips: rows 6 i … 6 i + 2 of `jacobian` [6 m,
/// n] are the position Jacobian of tip i, the next three its rotation Jacobian. `jacobian` is
/// overwritten.
void tip_jacobians(const RobotModel& robot, const std::vector<Pose>& base_from_frame,
                   Eigen::Ref<Eigen::MatrixXd> jacobian);

}  // namespace morphe::robot
