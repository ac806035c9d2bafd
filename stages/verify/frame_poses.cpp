#include "stages/verify/frame_poses.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::verify {
namespace {

bool is_ancestor(const RobotModel& robot, int ancestor, int frame) {
  for (; frame >= 0; frame = robot.frames[frame].parent) {
    if (frame == ancestor) return true;
  }
  return false;
}

double longest_slide(const RobotModel& robot, const RobotModel::Frame& frame) {
  if (!frame.prismatic || frame.joint < 0) return 0;
  return std::max(std::abs(frame.ratio * robot.lower(frame.joint) + frame.offset),
                  std::abs(frame.ratio * robot.upper(frame.joint) + frame.offset));
}

/// Adds the joints that move `capsule` but not a body fixed to `other_frame`.
void add_motion_bounds(const RobotModel& robot, const RobotModel::Capsule& capsule, int other_frame,
                       JointVector& lever) {
  double distance = std::max(capsule.from.norm(), capsule.to.norm());
  for (int index = capsule.frame; index >= 0;) {
    if (is_ancestor(robot, index, other_frame)) return;
    const RobotModel::Frame& frame = robot.frames[index];
    if (frame.joint >= 0)
      lever(frame.joint) += std::abs(frame.ratio) * (frame.prismatic ? 1 : distance);
    distance += frame.transform.translation().norm() + longest_slide(robot, frame);
    index = frame.parent;
  }
}

}  // namespace

void frame_poses(const RobotModel& robot, const JointVector& q,
                 std::vector<Pose>& base_from_frame) {
  base_from_frame.resize(robot.frames.size());
  for (std::size_t i = 0; i < robot.frames.size(); ++i) {
    const RobotModel::Frame& frame = robot.frames[i];
    Pose& pose = base_from_frame[i];
    pose = frame.parent < 0 ? frame.transform : base_from_frame[frame.parent] * frame.transform;
    if (frame.joint < 0) continue;
    const double value = frame.ratio * q(frame.joint) + frame.offset;
    if (frame.prismatic) {
      pose.translation() += pose.linear() * (value * frame.axis);
    } else {
      pose.linear() = pose.linear() * Eigen::AngleAxisd(value, frame.axis).toRotationMatrix();
    }
  }
}

JointVector relative_motion_bound(const RobotModel& robot, int first, int second) {
  JointVector lever = JointVector::Zero(robot.joints());
  const RobotModel::Capsule& a = robot.capsules[first];
  if (second < 0) {
    add_motion_bounds(robot, a, -1, lever);
    return lever;
  }
  const RobotModel::Capsule& b = robot.capsules[second];
  add_motion_bounds(robot, a, b.frame, lever);
  add_motion_bounds(robot, b, a.frame, lever);
  return lever;
}

JointVector relative_motion_bound(const RobotModel& robot, int first, int frame, const Vec3& centre,
                                  double radius) {
  JointVector lever = JointVector::Zero(robot.joints());
  const RobotModel::Capsule& a = robot.capsules[first];
  RobotModel::Capsule body;  // only its farthest point matters
  body.frame = frame;
  body.from = body.to = (centre.norm() + radius) * Vec3::UnitX();
  add_motion_bounds(robot, a, frame, lever);
  add_motion_bounds(robot, body, a.frame, lever);
  return lever;
}

JointVector point_motion_bound(const RobotModel& robot, int frame, double reach) {
  JointVector lever = JointVector::Zero(robot.joints());
  RobotModel::Capsule body;  // only its farthest point matters
  body.frame = frame;
  body.from = body.to = reach * Vec3::UnitX();
  add_motion_bounds(robot, body, -1, lever);
  return lever;
}

}  // namespace morphe::verify
