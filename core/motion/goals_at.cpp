#include "core/motion/goals_at.hpp"

#include <algorithm>

namespace morphe {

GoalTime goal_time(const Goals& goals, double time_s) {
  const auto next = std::ranges::lower_bound(goals.time, time_s);
  const auto after = static_cast<std::size_t>(next - goals.time.begin());
  if (after == goals.frames()) return {after - 1, after - 1, 0};
  if (after == 0 || *next == time_s) return {after, after, 0};
  const double before_s = goals.time[after - 1];
  return {after - 1, after, (time_s - before_s) / (goals.time[after] - before_s)};
}

Vec3 tip_goal_at(const Goals& goals, std::size_t tip, double time_s) {
  const GoalTime at = goal_time(goals, time_s);
  return (1 - at.share) * goals.tip_position(at.before, tip) +
         at.share * goals.tip_position(at.after, tip);
}

double pad_share_at(const Goals& goals, std::size_t tip, double time_s) {
  if (goals.pad_share.rows == 0) return 0;
  const GoalTime at = goal_time(goals, time_s);
  return (1 - at.share) * goals.pad_share(at.before, tip) +
         at.share * goals.pad_share(at.after, tip);
}

Quat tip_orientation_goal_at(const Goals& goals, std::size_t tip, double time_s) {
  if (goals.tip_orientation.rows == 0) return unseen_rotation();
  const GoalTime at = goal_time(goals, time_s);
  const Quat& before = goals.tip_orientation(at.before, tip);
  const Quat& after = goals.tip_orientation(at.after, tip);
  if (!seen(before) || !seen(after)) return unseen_rotation();
  return before.slerp(at.share, after);
}

Vec3 point_at(const std::vector<Vec3>& points, const GoalTime& at) {
  if (points.empty()) return unseen_point();
  return (1 - at.share) * points[at.before] + at.share * points[at.after];
}

GoalCount count_goals(const Goals& goals) {
  GoalCount count;
  for (std::size_t k = 0; k < goals.tip_position.values.size(); ++k) {
    if (!seen(goals.tip_position.values[k])) continue;
    if (!goals.closed.empty() && goals.closed[k % goals.tip_position.cols] != 0) continue;
    ++count.all;
    count.out_of_reach += goals.reachable.values[k] == 0 ? 1U : 0U;
  }
  return count;
}

}  // namespace morphe
