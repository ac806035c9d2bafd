#pragma once

#include <optional>

#include "core/motion/robot_model.hpp"
#include "stages/verify/curve.hpp"
#include "stages/verify/violation_collector.hpp"

namespace morphe::verify {

/// The goals at a demonstration time as an interpolation between two frames, `share` of the way
/// from `before` to `after`. Constant before the first frame and after the last; at a frame's own
/// instant both are that frame.
struct GoalInterpolation {
  std::size_t before = 0, after = 0;
  double share = 0;
};
/// Returns the two goal frames around a demonstration time and the interpolation share.
GoalInterpolation interpolate_goal_frames(const Goals& goals, double time_s);

/// Returns true if a demonstration time is within a phase grasp or hold, borders included.
bool is_grasping(const std::vector<Phase>& phases, double time_s);

/// Returns the goal position of a tip at a demonstration time: linear between the goals' frames,
/// constant before the first and after the last; nullopt if the tip is unseen in one of the two
/// frames around the time.
std::optional<Vec3> goal_at(const Goals& goals, std::size_t tip, double time_s);

/// Records `tracking` violations for each tip that is farther from its goal than the plan
/// tolerates: `tracking_tolerance_grasp` in grasp and hold, otherwise `tracking`; between samples,
/// where the bound is proved by bisection, 1e-4 m more.
void verify_tracking(const RobotModel& robot, const Plan& plan, const Curve& curve,
                     ViolationCollector& runs);

}  // namespace morphe::verify
