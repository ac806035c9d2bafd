#pragma once

#include <optional>

#include "core/motion/robot_model.hpp"
#include "stages/verify/curve.hpp"
#include "stages/verify/violation_log.hpp"

namespace morphe::verify {

/// The goals at a demonstration time as an interpolation between two frames, `share` of the way
/// from `before` to `after`. Constant before the first frame and after the last; at a frame's own
/// instant both are that frame.
struct GoalInterpolation {
  int before = 0, after = 0;
  double share = 0;
};
/// Returns the two goal frames around a demonstration time and the interpolation share.
GoalInterpolation interpolate_goal_frames(const Goals& goals, double time_s);

/// Returns true if a demonstration time is within a phase grasp, or a hold that begins before the
/// last transport has ended, borders included.
bool is_grasping(const std::vector<Phase>& phases, double time_s);

/// Returns the goal position of a tip at a demonstration time, interpolated as above; nullopt if
/// one of the two frames has no goal for the tip.
std::optional<Vec3> goal_at(const Goals& goals, int tip, double time_s);

/// Records `tracking` violations for each tip that is farther from its goal than the plan's
/// `tracking_tolerance_grasp` in grasp and hold, or its `tracking_tolerance` elsewhere. Between
/// samples, where this is proved by bisection, the distance may be 1e-4 m more.
void verify_tracking(const RobotModel& robot, const Plan& plan, const Curve& curve,
                     ViolationLog& violations);

}  // namespace morphe::verify
