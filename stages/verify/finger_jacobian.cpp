#include "stages/verify/finger_jacobian.hpp"

#include <vector>

#include "stages/verify/frame_poses.hpp"

namespace morphe::verify {
namespace {

bool moves_palm(const RobotModel& robot, int joint) {
  for (int frame = robot.palm_frame; frame >= 0; frame = robot.frames[frame].parent) {
    if (robot.frames[frame].joint == joint) return true;
  }
  return false;
}

}  // namespace

Eigen::Matrix3Xd finger_jacobian(const RobotModel& robot, const JointVector& q, int frame,
                                 const Vec3& point_in_base) {
  constexpr double kDifferenceStep = 1e-5;
  Eigen::Matrix3Xd levers = Eigen::Matrix3Xd::Zero(3, q.size());
  if (frame < 0) return levers;
  std::vector<Pose> base_from_frame;
  const auto pose = [&](const JointVector& at) -> const Pose& {
    frame_poses(robot, at, base_from_frame);
    return base_from_frame[frame];
  };
  const Vec3 point = pose(q).inverse() * point_in_base;
  for (Eigen::Index joint = 0; joint < q.size(); ++joint) {
    if (moves_palm(robot, static_cast<int>(joint))) continue;
    JointVector moved = q;
    moved[joint] = q[joint] + kDifferenceStep;
    const Vec3 after = pose(moved) * point;
    moved[joint] = q[joint] - kDifferenceStep;
    levers.col(joint) = (after - pose(moved) * point) / (2 * kDifferenceStep);
  }
  return levers;
}

}  // namespace morphe::verify
