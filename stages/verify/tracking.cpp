#include "stages/verify/tracking.hpp"

#include <algorithm>

namespace morphe::verify {

GoalInterpolation interpolate_goal_frames(const Goals& goals, double time_s) {
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
  const GoalInterpolation at = interpolate_goal_frames(goals, time_s);
  const Vec3 goal = (1 - at.share) * goals.tip_position(at.before, tip) +
                    at.share * goals.tip_position(at.after, tip);
  return goal.allFinite() ? std::optional<Vec3>(goal) : std::nullopt;
}

}  // namespace morphe::verify
