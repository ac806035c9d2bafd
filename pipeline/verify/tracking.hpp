#pragma once

#include <optional>

#include "pipeline/verify/curve.hpp"
#include "pipeline/verify/violation_runs.hpp"

namespace morphe::judge {

/// Where a tip should be at a demonstration time: linear between the goals' frames, held before the
/// first and after the last; nothing where one of the two frames around it has not seen the tip.
std::optional<Vec3> goal_at(const Goals& goals, std::size_t tip, double time_s);

/// Notes `tracking` for each tip and sample farther from its goal than the plan tolerates: in grasp
/// and hold `tracking_grasp`, elsewhere `tracking`. Returns the largest error [m], NaN if there is
/// no goal at all.
double judge_tracking(const RobotTable& robot, const Plan& plan, ViolationRuns& runs);

}  // namespace morphe::judge
