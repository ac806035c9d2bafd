#include "stages/verify/finger_jacobian.hpp"

#include <vector>

#include "stages/verify/frame_poses.hpp"

namespace morphe::verify {
namespace {

bool moves_palm(const RobotModel& robot, int joint) {
  int frame = robot.palm_frame;
  while (frame >= 0 && robot.frames[frame].joint != joint) frame = robot.frames[frame].parent;
  return frame >= 0;
}

}  // namespace

Eigen::Matrix3Xd finger_jacobian(const RobotModel& robot, const JointVector& q, int frame,
                                 const Vec3& point_in_base) {
  constexpr double kDifferenceStep = 1e-5;
  Eigen::Matrix3Xd jacobian = Eigen::Matrix3Xd::Zero(3, q.size());
  if (frame < 0) return jacobian;
  std::vector<Pose> base_from_frame;
  const auto pose_at = [&](const JointVector& position) -> const Pose& {
    frame_poses(robot, position, base_from_frame);
    return base_from_frame[frame];
  };
  const Vec3 point = pose_at(q).inverse() * point_in_base;
  for (int joint = 0; joint < q.size(); ++joint) {
    if (moves_palm(robot, joint)) continue;
    JointVector moved = q;
    moved[joint] = q[joint] + kDifferenceStep;
    const Vec3 after = pose_at(moved) * point;
    moved[joint] = q[joint] - kDifferenceStep;
    jacobian.col(joint) = (after - pose_at(moved) * point) / (2 * kDifferenceStep);
  }
  return jacobian;
}

}  // namespace morphe::verify
