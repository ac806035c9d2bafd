#include "stages/verify/frame_poses.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::verify {
namespace {

bool carries(const RobotTable& robot, int ancestor, int frame) {
  for (; frame >= 0; frame = robot.frames[static_cast<std::size_t>(frame)].parent) {
    if (frame == ancestor) return true;
  }
  return false;
}

double longest_slide(const RobotTable& robot, const RobotTable::Frame& frame) {
  if (!frame.slides || frame.joint < 0) return 0;
  return std::max(std::abs(frame.ratio * robot.lower(frame.joint) + frame.offset),
                  std::abs(frame.ratio * robot.upper(frame.joint) + frame.offset));
}

/// Adds the joints that carry `capsule` but not a body that sits on `other_frame`.
void add_levers(const RobotTable& robot, const RobotTable::Capsule& capsule, int other_frame,
                JointVector& lever) {
  double distance = std::max(capsule.from.norm(), capsule.to.norm());
  for (int index = capsule.frame; index >= 0;) {
    if (carries(robot, index, other_frame)) return;
    const RobotTable::Frame& frame = robot.frames[static_cast<std::size_t>(index)];
    if (frame.joint >= 0)
      lever(frame.joint) += std::abs(frame.ratio) * (frame.slides ? 1 : distance);
    distance += frame.transform.translation().norm() + longest_slide(robot, frame);
    index = frame.parent;
  }
}

}  // namespace

void frame_poses(const RobotTable& robot, const JointVector& q,
                 std::vector<Pose>& base_from_frame) {
  base_from_frame.resize(robot.frames.size());
  for (std::size_t i = 0; i < robot.frames.size(); ++i) {
    const RobotTable::Frame& frame = robot.frames[i];
    Pose& pose = base_from_frame[i];
    pose = frame.parent < 0
               ? frame.transform
               : base_from_frame[static_cast<std::size_t>(frame.parent)] * frame.transform;
    if (frame.joint < 0) continue;
    const double value = frame.ratio * q(frame.joint) + frame.offset;
    if (frame.slides) {
      pose.translation() += pose.linear() * (value * frame.axis);
    } else {
      pose.linear() = pose.linear() * Eigen::AngleAxisd(value, frame.axis).toRotationMatrix();
    }
  }
}

JointVector relative_lever(const RobotTable& robot, int first, int second) {
  JointVector lever = JointVector::Zero(static_cast<Eigen::Index>(robot.joints()));
  const RobotTable::Capsule& a = robot.capsules[static_cast<std::size_t>(first)];
  if (second < 0) {
    add_levers(robot, a, -1, lever);
    return lever;
  }
  const RobotTable::Capsule& b = robot.capsules[static_cast<std::size_t>(second)];
  add_levers(robot, a, b.frame, lever);
  add_levers(robot, b, a.frame, lever);
  return lever;
}

JointVector relative_lever(const RobotTable& robot, int first, int frame, const Vec3& centre,
                           double radius) {
  JointVector lever = JointVector::Zero(static_cast<Eigen::Index>(robot.joints()));
  const RobotTable::Capsule& a = robot.capsules[static_cast<std::size_t>(first)];
  RobotTable::Capsule body;  // only its farthest point counts
  body.frame = frame;
  body.from = body.to = (centre.norm() + radius) * Vec3::UnitX();
  add_levers(robot, a, frame, lever);
  add_levers(robot, body, a.frame, lever);
  return lever;
}

JointVector point_lever(const RobotTable& robot, int frame, double reach) {
  JointVector lever = JointVector::Zero(static_cast<Eigen::Index>(robot.joints()));
  RobotTable::Capsule body;  // only its farthest point counts
  body.frame = frame;
  body.from = body.to = reach * Vec3::UnitX();
  add_levers(robot, body, -1, lever);
  return lever;
}

}  // namespace morphe::verify
