#include "core/robot/hand_dimensions.hpp"

#include <cmath>

#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"

namespace morphe::robot {
namespace {

/// Axes count as parallel if the cosine of the angle between them exceeds this.
constexpr double kParallelCosine = 0.9;

struct Axis {
  Vec3 point, direction;
  Vec3 foot_of(const Vec3& p) const { return point + direction.dot(p - point) * direction; }
};

/// Returns the flexion axes of a finger, the distal one first.
std::vector<Axis> bending_axes(const RobotModel& robot, const RobotModel::Tip& tip,
                               const std::vector<Pose>& base_from_frame) {
  std::vector<Axis> axes;
  for (const int f : ancestors(robot, tip.frame)) {
    if (is_in_subtree(robot, robot.palm_frame, f))
      break;  // the frame carries the palm, so it is part of the wrist
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
  for (std::size_t i = 0; i < robot.tips.size(); ++i) {
    const RobotModel::Tip& tip = robot.tips[i];
    if (tip.finger < 0) continue;
    const std::vector<Axis> axes = bending_axes(robot, tip, base_from_frame);
    if (axes.empty()) continue;
    const Vec3 end = tip_pose(robot, base_from_frame, i).translation();
    double length = 0;
    Vec3 here = end;
    for (const Axis& axis : axes) {
      const Vec3 foot = axis.foot_of(here);
      length += (here - foot).norm();
      here = foot;
    }
    const auto finger = static_cast<std::size_t>(tip.finger);
    bones.length[finger] = length;
    bones.knuckle[finger] = palm_from_base * here;
  }
  return bones;
}

}  // namespace morphe::robot
