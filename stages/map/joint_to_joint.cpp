#include "stages/map/joint_to_joint.hpp"

#include <algorithm>

#include "core/humanlike/arm_chain.hpp"
#include "core/humanlike/match_link_directions.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"
#include "stages/map/finger_angles.hpp"

namespace morphe::map {
namespace {

using Eigen::Index;

/// Sets the joints of fingers that never have an angle to zero, or the limit next to it.
void zero_unrecorded_fingers(const robot::Robot& robot, std::vector<humanlike::FrameGoal>& frames,
                             Goals& goals) {
  bool any = false;
  for (const RobotModel::Tip& tip : robot.tips) {
    if (tip.finger < 0) continue;
    for (const int frame : robot::ancestors(robot, tip.frame)) {
      if (frame == robot.palm_frame) break;
      const int joint = robot::joint_of(robot, frame);
      const bool recorded =
          joint < 0 || std::ranges::any_of(frames, [&](const humanlike::FrameGoal& goal) {
            return std::isfinite(goal.angles[joint]);
          });
      if (recorded) continue;
      any = true;
      for (humanlike::FrameGoal& goal : frames) {
        goal.angles[joint] = std::clamp(0.0, robot.lower[joint], robot.upper[joint]);
      }
    }
  }
  if (any) goals.estimated.emplace_back("finger angles");
}

}  // namespace

std::vector<humanlike::FrameGoal> joint_to_joint_goals(const robot::Robot& robot,
                                                       const JointRows& angles,
                                                       const std::vector<double>& angle_time,
                                                       Goals& goals) {
  std::vector<Pose> poses;
  robot::forward_kinematics(robot, JointVector::Zero(robot.joints()), poses);
  const humanlike::Chain arm = humanlike::arm_chain(robot, poses).joints;
  FingerAngles finger_angles(robot);
  std::vector<humanlike::FrameGoal> frames;
  for (std::size_t f = 0; f < goals.frames(); ++f) {
    humanlike::FrameGoal goal;
    goal.tip_position.assign(robot.tips.size(), unknown_point());
    goal.tip_orientation.assign(robot.tips.size(), unknown_rotation());
    goal.hand = goals.wrist_orientation[f];
    if (arm.size() > 1) {
      goal.chain = humanlike::match_link_directions(
          {goals.shoulder_position[f], goals.elbow_position[f], goals.wrist_position[f]}, arm);
    }
    goal.angles = JointVector::Constant(robot.joints(), kUnknown);
    const auto row =
        std::lower_bound(angle_time.begin(), angle_time.end(), goals.time[f]) - angle_time.begin();
    if (row < angles.rows()) goal.angles = finger_angles(angles.row(row).transpose());
    frames.push_back(std::move(goal));
  }
  zero_unrecorded_fingers(robot, frames, goals);
  return frames;
}

}  // namespace morphe::map
