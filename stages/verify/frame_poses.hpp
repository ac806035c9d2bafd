#pragma once

#include <vector>

#include "core/motion/robot_table.hpp"

namespace morphe::verify {

/// base_from_frame of all frames: parent * transform * Rotation(axis, ratio * q[joint] + offset).
void frame_poses(const RobotTable& robot, const JointVector& q, std::vector<Pose>& base_from_frame);

/// A point given in a frame (-1 = base), in the base frame.
inline Vec3 in_base(const std::vector<Pose>& base_from_frame, int frame, const Vec3& point) {
  return frame < 0 ? point : base_from_frame[static_cast<std::size_t>(frame)] * point;
}

/// lever [n]: |dx| <= sum_j lever_j |dq_j| for every point x of the axis of one capsule relative to
/// a second one, whatever the robot's position [m/rad]. `second` = -1: relative to the base. Joints
/// that carry both capsules do not count; each other one counts with the greatest distance from its
/// frame's origin that the links after it allow.
JointVector relative_lever(const RobotTable& robot, int first, int second);
/// The same, and for every point within `radius` of `centre` (given in `frame`) as the second body.
JointVector relative_lever(const RobotTable& robot, int first, int frame, const Vec3& centre,
                           double radius);

/// lever [n] of every point within `reach` of a frame's origin, relative to the base.
JointVector point_lever(const RobotTable& robot, int frame, double reach);

}  // namespace morphe::verify
