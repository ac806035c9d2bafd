#include "stages/verify/tracking.hpp"

#include <algorithm>

namespace morphe::verify {

GoalInterpolation interpolate_goal_frames(const Goals& goals, double time_s) {
  if (time_s <= goals.time.front()) return {0, 0, 0};
  const auto upper = std::ranges::upper_bound(goals.time, time_s);
  const int after = static_cast<int>(upper - goals.time.begin());
  const double before_s = goals.time[after - 1];
  if (upper == goals.time.end() || time_s == before_s) return {after - 1, after - 1, 0};
  return {after - 1, after, (time_s - before_s) / (goals.time[after] - before_s)};
}

bool is_grasping(const std::vector<Phase>& phases, double time_s) {
  double put_down_s = kInfinity;
  for (const Phase& phase : phases)
    if (phase.kind == PhaseKind::transport) put_down_s = phase.end_s;
  return std::ranges::any_of(phases, [&](const Phase& phase) {
    const bool tight = phase.kind == PhaseKind::grasp ||
                       (phase.kind == PhaseKind::hold && phase.begin_s < put_down_s);
    return tight && time_s >= phase.begin_s && time_s <= phase.end_s;
  });
}

std::optional<Vec3> goal_at(const Goals& goals, int tip, double time_s) {
  if (goals.time.empty()) return std::nullopt;
  const auto [before, after, share] = interpolate_goal_frames(goals, time_s);
  const Vec3 goal =
      (1 - share) * goals.tip_position(before, tip) + share * goals.tip_position(after, tip);
  return goal.allFinite() ? std::optional<Vec3>(goal) : std::nullopt;
}

}  // namespace morphe::verify
