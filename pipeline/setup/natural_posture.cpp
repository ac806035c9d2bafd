#include "pipeline/setup/natural_posture.hpp"

#include <cmath>
#include <set>

namespace morphe::setup {
namespace {

struct DrivenJoints {
  std::vector<int> bending;  ///< from the tip on
  std::vector<int> others;
};

/// Returns the joints that a finger drives itself, by their first frames.
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
  const auto& names = robot.table().joint_names;
  const auto name = [&](int joint) { return names[joint]; };
  const DrivenJoints index = driven_joints(robot, hand.fingers[1]);
  std::set<int> told;
  for (const int joint : index.bending) told.insert(joint);
  for (std::size_t i = 2; i < hand.fingers.size(); ++i) {
    const DrivenJoints own = driven_joints(robot, hand.fingers[i]);
    for (std::size_t k = 0; k < own.bending.size(); ++k) {
      if (!told.insert(own.bending[k]).second) continue;
      robot::NaturalJoint joint{name(own.bending[k]), "", robot.rest[own.bending[k]]};
      if (k < index.bending.size()) joint = {name(own.bending[k]), name(index.bending[k]), 0};
      natural.push_back(joint);
    }
    for (const int joint : own.others) {
      if (told.insert(joint).second) natural.push_back({name(joint), "", robot.rest[joint]});
    }
  }
  return natural;
}

}  // namespace morphe::setup
