#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"
#include "stages/verify/violation_runs.hpp"

namespace morphe::verify {

/// Notes `goals` where a plan with a trajectory has other goals than a movement of a person gives:
/// time             fewer than 5 frames (value: how many); not evenly spaced to 1e-6 s; the first
///                  or the last a step or more away from the movement's begin or end; s
/// tip_position     no tip has any; while a phase grasp or hold is planned, none; numbers in part
/// tip_orientation  neither a unit quaternion nor unseen; so of wrist_orientation
/// reachable        neither 0 nor 1; called in reach though farther from the base than all links
///                  together; m
/// What tips a person's recording did not show cannot be told from the plan.
void judge_promised_goals(const RobotTable& robot, const Plan& plan, ViolationRuns& runs);

}  // namespace morphe::verify
