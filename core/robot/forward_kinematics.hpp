#pragma once

#include <vector>

#include "core/motion/robot_model.hpp"

namespace morphe::robot {

/// Computes the poses base_from_frame of all frames at the joint positions q [n] [rad or m]:
///   base_from_frame = base_from_parent * transform * Rotation(axis, ratio * q[joint] + offset),
/// with a translation along the axis for prismatic frames. `base_from_frame` is resized.
void forward_kinematics(const RobotModel& robot, const Eigen::Ref<const JointVector>& q,
                        std::vector<Pose>& base_from_frame);

/// Returns base_from_tip of one tip, given the poses of the frames.
Pose tip_pose(const RobotModel& robot, const std::vector<Pose>& base_from_frame,
              std::ptrdiff_t tip);

/// Computes the Jacobian d point / d q of a point that moves with `frame` (-1 = the base), in the
/// base frame [m/rad or m/m]. A coupled frame adds ratio times its own column to that of the joint
/// that drives it. jacobian [3, n] is overwritten.
void point_jacobian(const RobotModel& robot, const std::vector<Pose>& base_from_frame, int frame,
                    const Vec3& point_in_base, Eigen::Ref<Eigen::Matrix3Xd> jacobian);

/// Adds direction · d point / d q to slope [n], for a point that moves with `frame`. Only the
/// joints from `frame` up to `ancestor`, which is excluded, count (-1 = the base: all joints).
void add_point_gradient(const RobotModel& robot, const std::vector<Pose>& base_from_frame,
                        int frame, int ancestor, const Vec3& point_in_base, const Vec3& direction,
                        Eigen::Ref<JointVector> slope);

/// Overwrites `jacobian` [6 m, n] with the Jacobians of all tips: rows 6 i … 6 i + 2 are the
/// position Jacobian of tip i, the next three its rotation Jacobian.
void tip_jacobians(const RobotModel& robot, const std::vector<Pose>& base_from_frame,
                   Eigen::Ref<Eigen::MatrixXd> jacobian);

}  // namespace morphe::robot
