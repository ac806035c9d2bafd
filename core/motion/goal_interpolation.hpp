#pragma once

#include <vector>

#include "core/motion/plan.hpp"

namespace morphe {

/// The functions below interpolate goals, of at least one frame, linearly (orientations by slerp).
/// They are constant beyond the ends, and NaN next to a frame without the goal.

/// The two frames around a demonstration time, and the weight of the later one.
struct FrameInterpolation {
  std::size_t before_frame = 0, after_frame = 0;
  double weight = 0;
};
/// Returns the frames to interpolate between at a demonstration time [s].
FrameInterpolation frame_interpolation(const Goals& goals, double time_s);

/// Returns the position goal of a tip [m].
Vec3 tip_goal_at(const Goals& goals, std::size_t tip, double time_s);
/// Returns the interpolated Goals::tip_to_pad_share of a tip, or 0 if the goals have no pad shares.
double pad_share_at(const Goals& goals, std::size_t tip, double time_s);
/// Returns the orientation goal of a tip, or NaN if the goals have no orientations.
Quat tip_orientation_goal_at(const Goals& goals, std::size_t tip, double time_s);
/// Returns the person's hand, Goals::wrist_orientation; NaN if it is unknown.
Quat wrist_orientation_at(const Goals& goals, double time_s);
/// Interpolates one of the goals' series of points, such as elbow_position; NaN if it is empty.
Vec3 interpolate_point(const std::vector<Vec3>& points, const FrameInterpolation& pair);

/// The number of the person's fingertip goals in all frames, and the number of those out of reach.
struct GoalCount {
  std::size_t all = 0, out_of_reach = 0;
  /// Returns the share of goals that are out of reach, 0 if there are no goals.
  double share_out_of_reach() const {
    return all > 0 ? static_cast<double>(out_of_reach) / static_cast<double>(all) : 0;
  }
};
/// Counts the fingertip goals, leaving out those that close a finger that was not recorded.
GoalCount count_goals(const Goals& goals);

}  // namespace morphe
