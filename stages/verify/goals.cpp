#include "stages/verify/goals.hpp"

#include <algorithm>
#include <cmath>

#include "stages/verify/tracking.hpp"

namespace morphe::verify {
namespace {

constexpr std::size_t kMinFrameCount = 5;
constexpr double kTimeStepTolerance_s = 1e-6;

void verify_goal_times(const Plan& plan, ViolationCollector& runs) {
  const std::vector<double>& time = plan.goals.time;
  if (time.size() < kMinFrameCount) {
    runs.note_plan("goals", "time", static_cast<double>(time.size()), kMinFrameCount);
    return;
  }
  const double step_s = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
  for (std::size_t f = 0; f + 1 < time.size(); ++f) {
    const double own_s = time[f + 1] - time[f];
    if (std::abs(own_s - step_s) <= kTimeStepTolerance_s) continue;
    runs.note_plan("goals", "time", own_s, step_s);
    break;
  }
  const auto near = [&](double goal_s, double movement_s) {
    if (!(std::abs(goal_s - movement_s) < step_s + kTimeStepTolerance_s))
      runs.note_plan("goals", "time", goal_s, movement_s);
  };
  near(time.front(), plan.movement.begin_s);
  near(time.back(), plan.movement.end_s);
}

bool has_tip_goal(const Goals& goals, std::size_t frame) {
  for (std::size_t tip = 0; tip < goals.tip_position.cols; ++tip)
    if (is_known(goals.tip_position(frame, tip))) return true;
  return false;
}

void verify_tip_positions(const Plan& plan, ViolationCollector& runs) {
  const Goals& goals = plan.goals;
  std::size_t seen_frames = 0, grasping = 0, grasping_seen = 0;
  for (std::size_t f = 0; f < goals.frames(); ++f) {
    const bool any = has_tip_goal(goals, f),
               grasp = is_grasping(plan.movement.phases, goals.time[f]);
    seen_frames += any ? 1 : 0;
    grasping += grasp ? 1 : 0;
    grasping_seen += grasp && any ? 1 : 0;
  }
  if (seen_frames == 0 || (grasping > 0 && grasping_seen == 0))
    runs.note_plan("goals", "tip_position", static_cast<double>(grasping_seen),
                   static_cast<double>(grasping));
  const bool in_part = std::ranges::any_of(goals.tip_position.values, [](const Vec3& point) {
    return !is_known(point) && !point.array().isNaN().all();
  });
  if (in_part) runs.note_plan("goals", "tip_position", kUnknown, kUnknown);
}

bool is_rotation_or_unseen(const Quat& rotation) {
  return rotation.coeffs().array().isNaN().all() || std::abs(rotation.norm() - 1) < 1e-6;
}

/// Returns an upper bound of the distance of any point of a tip from the base [m].
double longest_reach(const RobotModel& robot, const RobotModel::Tip& tip, double pad) {
  double reach = std::max(tip.transform.translation().norm(), pad);
  for (int index = tip.frame; index >= 0;) {
    const RobotModel::Frame& frame = robot.frames[index];
    reach += frame.transform.translation().norm();
    if (frame.prismatic && frame.joint >= 0)
      reach += std::max(std::abs(frame.ratio * robot.lower(frame.joint) + frame.offset),
                        std::abs(frame.ratio * robot.upper(frame.joint) + frame.offset));
    index = frame.parent;
  }
  return reach;
}

void verify_reachable(const RobotModel& robot, const Goals& goals, ViolationCollector& runs) {
  constexpr double kMaxPadOffset_m = 0.1;  // beyond the tip, for goals of the pad
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    const double reach = longest_reach(robot, robot.tips[tip], 0) +
                         (goals.tip_to_pad_share.rows > 0 ? kMaxPadOffset_m : 0.0);
    for (std::size_t f = 0; f < goals.frames(); ++f) {
      const std::uint8_t said = goals.reachable(f, tip);
      const double away = goals.tip_position(f, tip).norm();
      if (said > 1 || (said == 1 && away > reach)) {
        runs.note_plan("goals", "reachable", said > 1 ? said : away, said > 1 ? 1 : reach);
        return;
      }
    }
  }
}

}  // namespace

void verify_goals(const RobotModel& robot, const Plan& plan, ViolationCollector& runs) {
  verify_goal_times(plan, runs);
  verify_tip_positions(plan, runs);
  if (!std::ranges::all_of(plan.goals.tip_orientation.values, is_rotation_or_unseen))
    runs.note_plan("goals", "tip_orientation", kUnknown, kUnknown);
  if (!std::ranges::all_of(plan.goals.wrist_orientation, is_rotation_or_unseen))
    runs.note_plan("goals", "wrist_orientation", kUnknown, kUnknown);
  verify_reachable(robot, plan.goals, runs);
}

}  // namespace morphe::verify
