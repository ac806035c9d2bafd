#pragma once

#include <vector>

#include "core/motion/robot_table.hpp"

namespace morphe::robot {

/// base_from_frame = base_from_parent * transform * Rotation(axis, ratio * q[joint] + offset), a
/// Translation along the axis where it slides, for every frame of the robot, in one pass, parents
/// first. `base_from_frame` is resized once and can be reused. q [n] [rad or m].
void forward(const RobotTable& robot, const Eigen::Ref<const JointVector>& q,
             std::vector<Pose>& base_from_frame);

/// base_from_tip of one tip, given the frames' poses.
Pose tip_pose(const RobotTable& robot, const std::vector<Pose>& base_from_frame, std::size_t tip);

/// d point / d q of a point that moves with `frame` (-1 = base: zero), in the base frame [m/rad],
/// of joints that slide [m/m].
/// A coupled joint adds ratio times its column to the joint that drives it. jacobian [3, n] is
/// overwritten.
void point_jacobian(const RobotTable& robot, const std::vector<Pose>& base_from_frame, int frame,
                    const Vec3& point_in_base, Eigen::Ref<Eigen::Matrix3Xd> jacobian);

/// slope [n] += direction · d point / d q of a point that moves with `frame`, by the joints from
/// there to below `ancestor` (-1 = the base: all of them).
void add_point_slope(const RobotTable& robot, const std::vector<Pose>& base_from_frame, int frame,
                     int ancestor, const Vec3& point_in_base, const Vec3& direction,
                     Eigen::Ref<JointVector> slope);

/// Both Jacobians of all tips at once: rows 6 i … 6 i + 2 of `jacobian` [6 m, n] are tip i's point
/// Jacobian, the next three its rotation Jacobian. Overwritten.
void tip_jacobians(const RobotTable& robot, const std::vector<Pose>& base_from_frame,
                   Eigen::Ref<Eigen::MatrixXd> jacobian);

}  // namespace morphe::robot
