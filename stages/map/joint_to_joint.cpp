#include "stages/map/joint_to_joint.hpp"

#include <algorithm>

#include "core/humanlike/arm_chain.hpp"
#include "core/humanlike/match_link_directions.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"
#include "stages/map/finger_angles.hpp"

namespace morphe::map {
namespace {

void zero_unrecorded_fingers(const robot::Robot& robot, std::vector<humanlike::FrameGoal>& frames,
                             Goals& goals) {
  bool any_zeroed = false;
  for (const RobotModel::Tip& tip : robot.tips) {
    if (tip.finger < 0) continue;
    for (const int frame : robot::ancestors(robot, tip.frame)) {
      if (frame == robot.palm_frame) break;
      const int joint = robot::joint_of(robot, frame);
      const auto recorded = [&](const auto& goal) { return std::isfinite(goal.angles[joint]); };
      if (joint < 0 || std::ranges::any_of(frames, recorded)) continue;
      any_zeroed = true;
      for (humanlike::FrameGoal& goal : frames) {
        goal.angles[joint] = std::clamp(0.0, robot.lower[joint], robot.upper[joint]);
      }
    }
  }
  if (any_zeroed) goals.estimated.emplace_back("finger angles");
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
  for (int f = 0; f < std::ssize(goals.time); ++f) {
    humanlike::FrameGoal goal;
    goal.tip_position.assign(robot.tips.size(), unknown_point());
    goal.tip_orientation.assign(robot.tips.size(), unknown_rotation());
    goal.hand = goals.wrist_orientation[f];
    if (arm.size() > 1) {
      goal.chain = humanlike::match_link_directions(
          {goals.shoulder_position[f], goals.elbow_position[f], goals.wrist_position[f]}, arm);
    }
    goal.angles = JointVector::Constant(robot.joints(), kUnknown);
    const auto row = std::ranges::lower_bound(angle_time, goals.time[f]) - angle_time.begin();
    if (row < angles.rows()) goal.angles = finger_angles(angles.row(row).transpose());
    frames.push_back(std::move(goal));
  }
  zero_unrecorded_fingers(robot, frames, goals);
  return frames;
}

}  // namespace morphe::map
