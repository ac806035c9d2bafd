#include "core/robot/hand_bones.hpp"

#include <cmath>

#include "core/robot/forward.hpp"
#include "core/robot/tree.hpp"

namespace morphe::robot {
namespace {

constexpr double kParallel = 0.9;  ///< cosine

struct Axis {
  Vec3 point, direction;
  Vec3 foot_of(const Vec3& p) const { return point + direction.dot(p - point) * direction; }
};

/// The axes that bend a finger, the last one first.
std::vector<Axis> bending_axes(const RobotTable& robot, const RobotTable::Tip& tip,
                               const std::vector<Pose>& base_from_frame) {
  std::vector<Axis> axes;
  for (const int f : upwards(robot, tip.frame)) {
    if (hangs_on(robot, robot.palm_frame, f)) break;  // it carries the palm: a wrist, no finger
    if (joint_of(robot, f) < 0 || robot.frames[static_cast<std::size_t>(f)].slides) continue;
    const Pose& pose = base_from_frame[static_cast<std::size_t>(f)];
    const Axis axis{pose.translation(),
                    pose.linear() * robot.frames[static_cast<std::size_t>(f)].axis};
    const bool parallel =
        axes.empty() || std::abs(axis.direction.dot(axes.front().direction)) > kParallel;
    if (parallel) axes.push_back(axis);
  }
  return axes;
}

}  // namespace

HandBones hand_bones(const RobotTable& robot) {
  HandBones bones;
  std::vector<Pose> base_from_frame;
  const JointVector zero = JointVector::Zero(static_cast<Eigen::Index>(robot.joints()));
  forward(robot, zero.cwiseMax(robot.lower).cwiseMin(robot.upper), base_from_frame);
  const Pose palm_from_base = base_from_frame[static_cast<std::size_t>(robot.palm_frame)].inverse();
  for (std::size_t i = 0; i < robot.tips.size(); ++i) {
    const RobotTable::Tip& tip = robot.tips[i];
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
