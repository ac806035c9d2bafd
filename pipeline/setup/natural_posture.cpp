#include "pipeline/setup/natural_posture.hpp"

#include <cmath>
#include <set>

namespace morphe::setup {
namespace {

struct DrivenJoints {
  std::vector<int> bending;  ///< from the tip on
  std::vector<int> others;
};

/// Returns the joints that move a finger, each once. Other joints than bending ones count only at
/// their own frame, not where they move a coupled one.
DrivenJoints driven_joints(const Kinematics& robot, const Finger& finger) {
  constexpr double kMinBendingAxisCosine = 0.8;
  DrivenJoints joints;
  std::set<int> seen;
  const int last = finger.frames.back();
  const Vec3 axis = robot.axis(last).direction;
  for (auto f = finger.frames.rbegin(); f != finger.frames.rend(); ++f) {
    const RobotModel::Frame& frame = robot.frame(*f);
    const bool drives = frame.name == robot.table().joint_names[frame.joint];
    const bool bends = std::abs(robot.axis(*f).direction.dot(axis)) > kMinBendingAxisCosine;
    if (bends && seen.insert(frame.joint).second) joints.bending.push_back(frame.joint);
    if (!bends && drives && seen.insert(frame.joint).second) joints.others.push_back(frame.joint);
  }
  return joints;
}

}  // namespace

std::vector<robot::NaturalJoint> natural_posture(const Kinematics& robot, const Hand& hand) {
  std::vector<robot::NaturalJoint> natural;
  if (hand.gripper || hand.fingers.size() < 3) return natural;
  const auto name = [&](int joint) { return robot.table().joint_names[joint]; };
  const DrivenJoints index = driven_joints(robot, hand.fingers[1]);
  std::set<int> assigned(index.bending.begin(), index.bending.end());
  for (int i = 2; i < std::ssize(hand.fingers); ++i) {
    const DrivenJoints own = driven_joints(robot, hand.fingers[i]);
    for (int k = 0; k < std::ssize(own.bending); ++k) {
      if (!assigned.insert(own.bending[k]).second) continue;
      robot::NaturalJoint joint{name(own.bending[k]), "", robot.rest[own.bending[k]]};
      if (k < std::ssize(index.bending)) joint = {name(own.bending[k]), name(index.bending[k]), 0};
      natural.push_back(joint);
    }
    for (const int joint : own.others)
      if (assigned.insert(joint).second) natural.push_back({name(joint), "", robot.rest[joint]});
  }
  return natural;
}

}  // namespace morphe::setup
