#include "core/robot/hand_dimensions.hpp"

#include <cmath>

#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"

namespace morphe::robot {
namespace {

constexpr double kParallelCosine = 0.9;  ///< axes with a larger cosine count as parallel

struct Axis {
  Vec3 point, direction;
  Vec3 foot_of(const Vec3& p) const { return point + direction.dot(p - point) * direction; }
};

/// Returns the flexion axes of a finger, the distal one first.
std::vector<Axis> flexion_axes(const RobotModel& robot, const RobotModel::Tip& tip,
                               const std::vector<Pose>& base_from_frame) {
  std::vector<Axis> axes;
  for (const int f : ancestors(robot, tip.frame)) {
    if (is_in_subtree(robot, robot.palm_frame, f)) break;  // part of the wrist
    if (joint_of(robot, f) < 0 || robot.frames[f].prismatic) continue;
    const Pose& pose = base_from_frame[f];
    const Axis axis{pose.translation(), pose.linear() * robot.frames[f].axis};
    const bool parallel =
        axes.empty() || std::abs(axis.direction.dot(axes.front().direction)) > kParallelCosine;
    if (parallel) axes.push_back(axis);
  }
  return axes;
}

}  // namespace

HandBones hand_dimensions(const RobotModel& robot) {
  HandBones bones;
  std::vector<Pose> base_from_frame;
  const JointVector zero = JointVector::Zero(robot.joints());
  forward_kinematics(robot, zero.cwiseMax(robot.lower).cwiseMin(robot.upper), base_from_frame);
  const Pose palm_from_base = base_from_frame[robot.palm_frame].inverse();
  for (int i = 0; i < std::ssize(robot.tips); ++i) {
    const RobotModel::Tip& tip = robot.tips[i];
    if (tip.finger < 0) continue;
    const std::vector<Axis> axes = flexion_axes(robot, tip, base_from_frame);
    if (axes.empty()) continue;
    double length = 0;
    Vec3 point = tip_pose(robot, base_from_frame, i).translation();
    for (const Axis& axis : axes) {
      const Vec3 foot = axis.foot_of(point);
      length += (point - foot).norm();
      point = foot;
    }
    bones.length[tip.finger] = length;
    bones.knuckle[tip.finger] = palm_from_base * point;
  }
  return bones;
}

}  // namespace morphe::robot
