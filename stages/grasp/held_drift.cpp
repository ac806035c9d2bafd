#include "stages/grasp/held_drift.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/motion/movement.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "stages/grasp/desired_contact.hpp"

namespace morphe::grasp {
namespace {

std::vector<std::ptrdiff_t> touching_tips(const robot::Robot& robot, const Grasp& grasp) {
  std::vector<std::ptrdiff_t> tips;
  for (const PadContact& contact : grasp.contacts) {
    const auto tip = std::ranges::find(robot.tips, contact.tip, &RobotModel::Tip::name);
    if (contact.state == ContactState::touching && tip != robot.tips.end())
      tips.push_back(tip - robot.tips.begin());
  }
  return tips;
}

/// Returns palm_from_pad of a tip: the rotation of its link and the centre of its pad.
Pose palm_from_pad(const robot::Robot& robot, const std::vector<Pose>& base_from_frame,
                   std::ptrdiff_t tip) {
  Pose base_from_pad = base_from_frame[robot.tips[tip].frame];
  base_from_pad.translation() = robot::tracked_point(robot, base_from_frame, tip, 1);
  return base_from_frame[robot.palm_frame].inverse() * base_from_pad;
}

}  // namespace

HeldDrift held_drift(const robot::Robot& robot, const Plan& plan) {
  const std::vector<std::ptrdiff_t> tips = touching_tips(robot, plan.grasp);
  if (tips.empty() || std::isnan(carrying_begin_s(plan.movement))) return {};
  const double release_s = hold_interval(plan.movement).release_s;
  const Trajectory& motion = plan.trajectory;
  std::vector<Pose> base_from_frame, palm_from_pad_at_grasp;
  HeldDrift drift{0, 0};
  for (std::ptrdiff_t sample = plan.grasp.sample; sample < std::ssize(motion.time); ++sample) {
    if (motion.demonstration_time[sample] > release_s) break;
    const JointVector q = motion.position.row(sample);
    robot::forward_kinematics(robot, q, base_from_frame);
    for (std::size_t k = 0; k < tips.size(); ++k) {
      const Pose now = palm_from_pad(robot, base_from_frame, tips[k]);
      if (sample == plan.grasp.sample) palm_from_pad_at_grasp.push_back(now);
      const Pose moved = palm_from_pad_at_grasp[k].inverse() * now;
      drift.displacement_m = std::max(drift.displacement_m, moved.translation().norm());
      drift.turn_rad = std::max(drift.turn_rad, Eigen::AngleAxisd(moved.linear()).angle());
    }
  }
  return drift;
}

}  // namespace morphe::grasp
