#pragma once

#include <vector>

#include "core/motion/robot_model.hpp"

namespace morphe::verify {

/// Computes base_from_frame = base_from_parent * transform * rotation of every frame, by ratio
/// q[joint] + offset about its axis; a prismatic frame is translated along it instead.
void frame_poses(const RobotModel& robot, const JointVector& q, std::vector<Pose>& base_from_frame);

/// Transforms a point given in a frame (-1 = base) to the base frame.
inline Vec3 to_base_frame(const std::vector<Pose>& base_from_frame, int frame, const Vec3& point) {
  return frame < 0 ? point : base_from_frame[frame] * point;
}

/// Returns the greatest distance by which a prismatic frame moves its origin [m]; 0 for others.
double longest_slide(const RobotModel& robot, const RobotModel::Frame& frame);

/// Returns lever [n] with |dx| <= sum_j lever_j |dq_j| for every point x on the axis of one capsule
/// relative to a second one (-1: to the base), for all joint positions [m/rad]. The lever is 0 for
/// joints that move both capsules, and |ratio| for prismatic frames. For others it is |ratio| times
/// the greatest distance of x from the frame's origin that the subsequent links allow.
JointVector relative_motion_bound(const RobotModel& robot, int first, int second);
/// Returns the same bound of a capsule relative to every point within `radius` of `centre`, which
/// is given in `frame`.
JointVector relative_motion_bound(const RobotModel& robot, int capsule, int frame,
                                  const Vec3& centre, double radius);

/// Returns the same bound of every point within `radius` of a frame's origin relative to the base.
JointVector point_motion_bound(const RobotModel& robot, int frame, double radius);

}  // namespace morphe::verify
