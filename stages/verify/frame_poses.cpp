#include "stages/verify/frame_poses.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::verify {
namespace {

bool is_ancestor(const RobotModel& robot, int ancestor, int frame) {
  while (frame >= 0 && frame != ancestor) frame = robot.frames[frame].parent;
  return frame >= 0;
}

/// Adds the levers of joints that move a ball about `body_frame`'s origin but not `other_frame`.
void add_motion_bounds(const RobotModel& robot, int body_frame, double radius, int other_frame,
                       JointVector& lever) {
  double max_distance = radius;
  for (int index = body_frame; index >= 0; index = robot.frames[index].parent) {
    if (is_ancestor(robot, index, other_frame)) return;
    const RobotModel::Frame& frame = robot.frames[index];
    const double own_lever = std::abs(frame.ratio) * (frame.prismatic ? 1 : max_distance);
    if (frame.joint >= 0) lever(frame.joint) += own_lever;
    max_distance += frame.transform.translation().norm() + longest_slide(robot, frame);
  }
}

double radius_about_frame(const RobotModel::Capsule& capsule) {
  return std::max(capsule.from.norm(), capsule.to.norm());
}

}  // namespace

void frame_poses(const RobotModel& robot, const JointVector& q,
                 std::vector<Pose>& base_from_frame) {
  base_from_frame.resize(robot.frames.size());
  for (int i = 0; i < std::ssize(robot.frames); ++i) {
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

double longest_slide(const RobotModel& robot, const RobotModel::Frame& frame) {
  if (!frame.prismatic || frame.joint < 0) return 0;
  return std::max(std::abs(frame.ratio * robot.lower(frame.joint) + frame.offset),
                  std::abs(frame.ratio * robot.upper(frame.joint) + frame.offset));
}

JointVector relative_motion_bound(const RobotModel& robot, int first, int second) {
  JointVector lever = JointVector::Zero(robot.joints());
  const RobotModel::Capsule& a = robot.capsules[first];
  const RobotModel::Capsule b = second < 0 ? RobotModel::Capsule() : robot.capsules[second];
  add_motion_bounds(robot, a.frame, radius_about_frame(a), b.frame, lever);
  add_motion_bounds(robot, b.frame, radius_about_frame(b), a.frame, lever);
  return lever;
}

JointVector relative_motion_bound(const RobotModel& robot, int capsule, int frame,
                                  const Vec3& centre, double radius) {
  JointVector lever = JointVector::Zero(robot.joints());
  const RobotModel::Capsule& own = robot.capsules[capsule];
  add_motion_bounds(robot, own.frame, radius_about_frame(own), frame, lever);
  add_motion_bounds(robot, frame, centre.norm() + radius, own.frame, lever);
  return lever;
}

JointVector point_motion_bound(const RobotModel& robot, int frame, double radius) {
  JointVector lever = JointVector::Zero(robot.joints());
  add_motion_bounds(robot, frame, radius, -1, lever);
  return lever;
}

}  // namespace morphe::verify
