#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"
#include "stages/verify/violation_runs.hpp"

namespace morphe::verify {

/// Notes `structure` for numbers that no plan has, and on which the searches along a motion would
/// work without end: places and lengths of the robot, the scene and the goals beyond 1000 km,
/// joints beyond 1e6 rad or m, ratios of coupled frames beyond 1000; a motion of more than 6 hours;
/// goals that are more than 100,000 a second, or so dense that the motion has more than 4,000,000
/// of their steps, or more than 1000 and 100 for each of its samples. What is not finite is for
/// judge_structure(). False if there are any.
bool judge_magnitudes(const RobotTable& robot, const Plan& plan, ViolationRuns& runs);

/// The motion alone: of an approach or a retreat.
bool judge_magnitudes(const Trajectory& motion, ViolationRuns& runs);

}  // namespace morphe::verify
