#include "core/motion/goal_interpolation.hpp"

#include <algorithm>

namespace morphe {
namespace {

Quat interpolate_rotation(const Quat& before, const Quat& after, double weight) {
  if (!is_known(before) || !is_known(after)) return unknown_rotation();
  return before.slerp(weight, after);
}

}  // namespace

FrameInterpolation frame_interpolation(const Goals& goals, double time_s) {
  const auto next = std::ranges::lower_bound(goals.time, time_s);
  const std::size_t after = next - goals.time.begin();
  if (after == goals.frames()) return {after - 1, after - 1, 0};
  if (after == 0 || *next == time_s) return {after, after, 0};
  const double before_s = goals.time[after - 1];
  return {after - 1, after, (time_s - before_s) / (goals.time[after] - before_s)};
}

Vec3 tip_goal_at(const Goals& goals, std::size_t tip, double time_s) {
  const auto [before, after, weight] = frame_interpolation(goals, time_s);
  return (1 - weight) * goals.tip_position(before, tip) + weight * goals.tip_position(after, tip);
}

double pad_share_at(const Goals& goals, std::size_t tip, double time_s) {
  if (goals.tip_to_pad_share.rows == 0) return 0;
  const auto [before, after, weight] = frame_interpolation(goals, time_s);
  return (1 - weight) * goals.tip_to_pad_share(before, tip) +
         weight * goals.tip_to_pad_share(after, tip);
}

Quat tip_orientation_goal_at(const Goals& goals, std::size_t tip, double time_s) {
  if (goals.tip_orientation.rows == 0) return unknown_rotation();
  const FrameInterpolation frames = frame_interpolation(goals, time_s);
  return interpolate_rotation(goals.tip_orientation(frames.before_frame, tip),
                              goals.tip_orientation(frames.after_frame, tip), frames.weight);
}

Quat wrist_orientation_at(const Goals& goals, double time_s) {
  if (goals.wrist_orientation.empty()) return unknown_rotation();
  const FrameInterpolation frames = frame_interpolation(goals, time_s);
  return interpolate_rotation(goals.wrist_orientation[frames.before_frame],
                              goals.wrist_orientation[frames.after_frame], frames.weight);
}

Vec3 interpolate_point(const std::vector<Vec3>& points, const FrameInterpolation& pair) {
  if (points.empty()) return unknown_point();
  return (1 - pair.weight) * points[pair.before_frame] + pair.weight * points[pair.after_frame];
}

GoalCount count_goals(const Goals& goals) {
  GoalCount count;
  for (std::size_t k = 0; k < goals.tip_position.values.size(); ++k) {
    if (!is_known(goals.tip_position.values[k])) continue;
    if (!goals.auto_closed.empty() && goals.auto_closed[k % goals.tip_position.cols] != 0) continue;
    ++count.all;
    count.out_of_reach += goals.reachable.values[k] == 0 ? 1U : 0U;
  }
  return count;
}

}  // namespace morphe
