#pragma once

#include <optional>

#include "core/motion/robot_table.hpp"
#include "stages/verify/curve.hpp"
#include "stages/verify/violation_runs.hpp"

namespace morphe::verify {

/// Goals at a demonstration time: those of two frames, `share` of the way from one to the other.
/// Held before the first and after the last; a frame's own instant is that frame alone.
struct GoalShare {
  std::size_t before = 0, after = 0;
  double share = 0;
};
GoalShare goal_share(const Goals& goals, double time_s);

/// Whether a demonstration time lies in a phase grasp or hold, borders included.
bool is_grasping(const std::vector<Phase>& phases, double time_s);

/// Where a tip should be at a demonstration time: linear between the goals' frames, held before the
/// first and after the last; nothing where one of the two frames around it has not seen the tip.
std::optional<Vec3> goal_at(const Goals& goals, std::size_t tip, double time_s);

/// Notes `tracking` for each tip that is farther from its goal than the plan tolerates: in grasp
/// and hold `tracking_grasp`, elsewhere `tracking`; between samples, where it is proved by
/// bisection, 1e-4 m more.
void judge_tracking(const RobotTable& robot, const Plan& plan, const Curve& curve,
                    ViolationRuns& runs);

}  // namespace morphe::verify
