#pragma once

#include <vector>

#include "core/motion/robot_model.hpp"

namespace morphe::verify {

/// Computes base_from_frame of all frames: parent * transform * Rotation(axis, ratio * q[joint] +
/// offset).
void frame_poses(const RobotModel& robot, const JointVector& q, std::vector<Pose>& base_from_frame);

/// Transforms a point given in a frame (-1 = base) to the base frame.
inline Vec3 to_base_frame(const std::vector<Pose>& base_from_frame, int frame, const Vec3& point) {
  return frame < 0 ? point : base_from_frame[frame] * point;
}

/// Returns lever [n] with |dx| <= sum_j lever_j |dq_j| for every point x on the axis of one capsule
/// relative to a second one, for all joint positions [m/rad]. `second` = -1 means relative to the
/// base. Joints that move both capsules have a lever of 0; each other joint has the greatest
/// distance from its frame's origin that the subsequent links allow.
JointVector relative_motion_bound(const RobotModel& robot, int first, int second);
/// Returns the same bound with every point within `radius` of `centre` (given in `frame`) as the
/// second body.
JointVector relative_motion_bound(const RobotModel& robot, int first, int frame, const Vec3& centre,
                                  double radius);

/// Returns lever [n] of every point within `reach` of a frame's origin, relative to the base.
JointVector point_motion_bound(const RobotModel& robot, int frame, double reach);

}  // namespace morphe::verify
