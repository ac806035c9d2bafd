#pragma once

#include <vector>

#include "core/motion/plan.hpp"

namespace morphe {

/// Goals between their frames: linear (slerp), held at the ends, NaN where one of the two frames
/// has none. Goals must have a frame.

/// The two frames around a demonstration time, and the share of the later one.
struct GoalTime {
  std::size_t before = 0, after = 0;
  double share = 0;
};
GoalTime goal_time(const Goals& goals, double time_s);

Vec3 tip_goal_at(const Goals& goals, std::size_t tip, double time_s);
/// 0 where goals say nothing of pads.
double pad_share_at(const Goals& goals, std::size_t tip, double time_s);
Quat tip_orientation_goal_at(const Goals& goals, std::size_t tip, double time_s);
/// Of a column of the goals, as elbow_position; not seen if it is empty.
Vec3 point_at(const std::vector<Vec3>& points, const GoalTime& at);

/// The person's fingertip goals of all frames, and how many of them are out of reach.
struct GoalCount {
  std::size_t all = 0, out_of_reach = 0;
  double share_out_of_reach() const {
    return all > 0 ? static_cast<double>(out_of_reach) / static_cast<double>(all) : 0;
  }
};
GoalCount count_goals(const Goals& goals);

}  // namespace morphe
