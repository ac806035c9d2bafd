#include "stages/verify/goals.hpp"

#include <algorithm>
#include <cmath>

#include "stages/verify/frame_poses.hpp"
#include "stages/verify/tracking.hpp"

namespace morphe::verify {
namespace {

constexpr int kMinFrameCount = 5;
constexpr double kTimeStepTolerance_s = 1e-6;

void verify_goal_times(const Plan& plan, ViolationLog& violations) {
  const std::vector<double>& time = plan.goals.time;
  if (std::ssize(time) < kMinFrameCount) {
    violations.note_plan("goals", "time", static_cast<double>(time.size()), kMinFrameCount);
    return;
  }
  const double step_s = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
  for (int f = 1; f < std::ssize(time); ++f) {
    const double own_s = time[f] - time[f - 1];
    if (std::abs(own_s - step_s) <= kTimeStepTolerance_s) continue;
    violations.note_plan("goals", "time", own_s, step_s);
    break;
  }
  const auto check_near = [&](double goal_s, double movement_s) {
    if (!(std::abs(goal_s - movement_s) < step_s + kTimeStepTolerance_s))
      violations.note_plan("goals", "time", goal_s, movement_s);
  };
  check_near(time.front(), plan.movement.begin_s);
  check_near(time.back(), plan.movement.end_s);
}

void verify_tip_positions(const RobotModel& robot, const Plan& plan, ViolationLog& violations) {
  const Goals& goals = plan.goals;
  bool any_seen = false;
  int grasping = 0, grasping_seen = 0;
  for (int f = 0; f < std::ssize(goals.time); ++f) {
    bool seen = false;
    for (int tip = 0; tip < std::ssize(robot.tips); ++tip)
      seen = seen || is_known(goals.tip_position(f, tip));
    any_seen = any_seen || seen;
    if (!is_grasping(plan.movement.phases, goals.time[f])) continue;
    ++grasping;
    grasping_seen += seen ? 1 : 0;
  }
  if (!any_seen || (grasping > 0 && grasping_seen == 0))
    violations.note_plan("goals", "tip_position", grasping_seen, grasping);
  const bool partly_known = std::ranges::any_of(goals.tip_position.values, [](const Vec3& point) {
    return !is_known(point) && !point.array().isNaN().all();
  });
  if (partly_known) violations.note_plan("goals", "tip_position", kUnknown, kUnknown);
}

bool is_rotation_or_unseen(const Quat& rotation) {
  return rotation.coeffs().array().isNaN().all() || std::abs(rotation.norm() - 1) < 1e-6;
}

/// Returns an upper bound of the distance of a tip from the base [m].
double max_tip_distance(const RobotModel& robot, const RobotModel::Tip& tip) {
  double distance = tip.transform.translation().norm();
  for (int index = tip.frame; index >= 0; index = robot.frames[index].parent) {
    const RobotModel::Frame& frame = robot.frames[index];
    distance += frame.transform.translation().norm();
    distance += longest_slide(robot, frame);
  }
  return distance;
}

void verify_reachable(const RobotModel& robot, const Goals& goals, ViolationLog& violations) {
  constexpr double kMaxPadOffset_m = 0.1;  // beyond the tip, for goals of the pad
  for (int tip = 0; tip < std::ssize(robot.tips); ++tip) {
    const double max_distance = max_tip_distance(robot, robot.tips[tip]) +
                                (goals.tip_to_pad_share.rows > 0 ? kMaxPadOffset_m : 0.0);
    for (int f = 0; f < std::ssize(goals.time); ++f) {
      const std::uint8_t reachable = goals.reachable(f, tip);
      const double distance = goals.tip_position(f, tip).norm();
      if (reachable > 1 || (reachable == 1 && distance > max_distance)) {
        violations.note_plan("goals", "reachable", reachable > 1 ? reachable : distance,
                             reachable > 1 ? 1 : max_distance);
        return;
      }
    }
  }
}

}  // namespace

void verify_goals(const RobotModel& robot, const Plan& plan, ViolationLog& violations) {
  verify_goal_times(plan, violations);
  verify_tip_positions(robot, plan, violations);
  if (!std::ranges::all_of(plan.goals.tip_orientation.values, is_rotation_or_unseen))
    violations.note_plan("goals", "tip_orientation", kUnknown, kUnknown);
  if (!std::ranges::all_of(plan.goals.wrist_orientation, is_rotation_or_unseen))
    violations.note_plan("goals", "wrist_orientation", kUnknown, kUnknown);
  verify_reachable(robot, plan.goals, violations);
}

}  // namespace morphe::verify
