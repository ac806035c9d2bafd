#include "pipeline/verify/tracking.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/verify/frame_poses.hpp"
#include "pipeline/verify/pad.hpp"

namespace morphe::verify {
GoalShare goal_share(const Goals& goals, double time_s) {
  const std::size_t last = goals.frames() - 1;
  if (time_s <= goals.time.front()) return {0, 0, 0};
  if (time_s >= goals.time.back()) return {last, last, 0};
  const auto after = static_cast<std::size_t>(
      std::upper_bound(goals.time.begin(), goals.time.end(), time_s) - goals.time.begin());
  const double from_s = goals.time[after - 1];
  if (time_s == from_s) return {after - 1, after - 1, 0};
  return {after - 1, after, (time_s - from_s) / (goals.time[after] - from_s)};
}

bool is_grasping(const std::vector<Phase>& phases, double time_s) {
  return std::any_of(phases.begin(), phases.end(), [&](const Phase& phase) {
    return (phase.kind == PhaseKind::grasp || phase.kind == PhaseKind::hold) &&
           time_s >= phase.begin_s && time_s <= phase.end_s;
  });
}

std::optional<Vec3> goal_at(const Goals& goals, std::size_t tip, double time_s) {
  if (goals.time.empty()) return std::nullopt;
  const GoalShare at = goal_share(goals, time_s);
  const Vec3 goal = (1 - at.share) * goals.tip_position(at.before, tip) +
                    at.share * goals.tip_position(at.after, tip);
  return goal.allFinite() ? std::optional<Vec3>(goal) : std::nullopt;
}

void judge_tracking(const RobotTable& robot, const Plan& plan, ViolationRuns& runs) {
  const Trajectory& trajectory = plan.trajectory;
  const std::vector<PadBall> pads = pad_balls(robot);
  std::vector<Pose> base_from_frame;
  for (std::size_t sample = 0; sample < trajectory.samples(); ++sample) {
    const double time_s = trajectory.demonstration_time[sample];
    frame_poses(robot, trajectory.position.row(static_cast<Eigen::Index>(sample)).transpose(),
                base_from_frame);
    const double tolerance = is_grasping(plan.movement.phases, time_s)
                                 ? plan.tolerances.tracking_grasp
                                 : plan.tolerances.tracking;
    for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
      const std::optional<Vec3> goal = goal_at(plan.goals, tip, time_s);
      if (!goal) continue;
      const Vec3 position = in_base(base_from_frame, robot.tips[tip].frame,
                                    asked_point(robot, pads, plan.goals, tip, time_s));
      const double error = (position - *goal).norm();
      if (!(error <= tolerance))
        runs.note("tracking", robot.tips[tip].name,
                  {static_cast<int>(2 * sample), static_cast<int>(sample), trajectory.time[sample]},
                  error, tolerance, error - tolerance);
    }
  }
}

}  // namespace morphe::verify
