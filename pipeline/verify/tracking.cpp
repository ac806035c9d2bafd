#include "pipeline/verify/tracking.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/verify/frame_poses.hpp"

namespace morphe::judge {
namespace {

bool grasping(const std::vector<Phase>& phases, double time_s) {
  return std::any_of(phases.begin(), phases.end(), [&](const Phase& phase) {
    return (phase.name == "grasp" || phase.name == "hold") && time_s >= phase.begin_s &&
           time_s <= phase.end_s;
  });
}

}  // namespace

std::optional<Vec3> goal_at(const Goals& goals, std::size_t tip, double time_s) {
  const auto found = [&](const Vec3& goal) {
    return goal.allFinite() ? std::optional<Vec3>(goal) : std::nullopt;
  };
  if (goals.time.empty()) return std::nullopt;
  if (time_s <= goals.time.front()) return found(goals.tip_position(0, tip));
  if (time_s >= goals.time.back()) return found(goals.tip_position(goals.frames() - 1, tip));
  const auto after = static_cast<std::size_t>(
      std::upper_bound(goals.time.begin(), goals.time.end(), time_s) - goals.time.begin());
  const double share =
      (time_s - goals.time[after - 1]) / (goals.time[after] - goals.time[after - 1]);
  return found((1 - share) * goals.tip_position(after - 1, tip) +
               share * goals.tip_position(after, tip));
}

double judge_tracking(const RobotTable& robot, const Plan& plan, ViolationRuns& runs) {
  const Trajectory& trajectory = plan.trajectory;
  std::vector<Pose> base_from_frame;
  double largest = kNotSeen;
  for (std::size_t sample = 0; sample < trajectory.samples(); ++sample) {
    const double time_s = trajectory.demonstration_time[sample];
    frame_poses(robot, trajectory.position.row(static_cast<Eigen::Index>(sample)).transpose(),
                base_from_frame);
    const double tolerance = grasping(plan.movement.phases, time_s) ? plan.tolerances.tracking_grasp
                                                                    : plan.tolerances.tracking;
    for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
      const std::optional<Vec3> goal = goal_at(plan.goals, tip, time_s);
      if (!goal) continue;
      const Vec3 position =
          in_base(base_from_frame, robot.tips[tip].frame, robot.tips[tip].transform.translation());
      const double error = (position - *goal).norm();
      largest = std::fmax(largest, error);
      if (!(error <= tolerance))
        runs.note("tracking", robot.tips[tip].name,
                  {static_cast<int>(2 * sample), static_cast<int>(sample), trajectory.time[sample]},
                  error, tolerance, error - tolerance);
    }
  }
  return largest;
}

}  // namespace morphe::judge
