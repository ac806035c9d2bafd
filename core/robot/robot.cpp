#include "core/robot/robot.hpp"

#include <algorithm>
#include <utility>

#include "core/robot/motion_bounds.hpp"
#include "core/robot/tree.hpp"

namespace morphe::robot {
namespace {

constexpr const char* kArm = "arm";

/// Returns the first fingertip beyond a joint centre; -1 for a centre of the arm, or without one.
int distal_tip(const RobotModel& robot, const RobotModel::JointCentre& centre) {
  if (centre.chain == kArm) return -1;
  for (int tip = 0; tip < std::ssize(robot.tips); ++tip) {
    if (robot.tips[tip].finger < 0) continue;
    if (is_in_subtree(robot, robot.tips[tip].frame, centre.frame)) return tip;
  }
  return -1;
}

}  // namespace

Robot::Robot(RobotModel table) : RobotModel(std::move(table)) {
  for (int f = 0; f < std::ssize(frames); ++f) moving_frame.push_back(moving_frame_of(*this, f));
  const int palm = frames.empty() ? -1 : palm_frame;
  for (const int frame : ancestors(*this, palm)) {
    if (joint_of(*this, frame) >= 0) arm_joints.push_back(joint_of(*this, frame));
  }
  std::ranges::sort(arm_joints);
  arm_joints.erase(std::unique(arm_joints.begin(), arm_joints.end()), arm_joints.end());
  for (const JointCentre& centre : joint_centres) {
    if (centre.chain == kArm) arm_centres.push_back(centre.frame);
    tip_of_centre.push_back(distal_tip(*this, centre));
    chain_centre_count.push_back(
        static_cast<double>(std::ranges::count(joint_centres, centre.chain, &JointCentre::chain)));
  }
  pads = find_pads(*this);
  capsule_motion_bounds = robot::capsule_motion_bounds(*this);
}

bool is_pad(const Robot& robot, int capsule) {
  return std::ranges::find(robot.pads, capsule, &Pad::capsule) != robot.pads.end();
}

Vec3 tracked_point(const Robot& robot, const std::vector<Pose>& base_from_frame, std::ptrdiff_t tip,
                   double tip_to_pad_share) {
  const int frame = robot.tips[tip].frame;
  Vec3 point = robot.tips[tip].transform.translation();
  if (tip_to_pad_share > 0) point += tip_to_pad_share * (robot.pads[tip].centre - point);
  return frame < 0 ? point : base_from_frame[frame] * point;
}

std::vector<Vec3> arm_centre_positions(const Robot& robot,
                                       const std::vector<Pose>& base_from_frame) {
  std::vector<Vec3> positions;
  for (const int frame : robot.arm_centres)
    positions.push_back(base_from_frame[frame].translation());
  return positions;
}

}  // namespace morphe::robot
