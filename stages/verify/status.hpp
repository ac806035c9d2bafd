#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"
#include "stages/verify/violation_runs.hpp"

namespace morphe::verify {

/// Notes `status` for a plan with a trajectory that is called executable although more of its goals
/// are out of reach than it allows, or a tip farther from its goal at a sample; and for one that is
/// called approximate although neither is so. What is in reach is taken from the file. Files that
/// do not say what they allow are not judged.
void judge_status(const RobotTable& robot, const Plan& plan, ViolationRuns& runs);

}  // namespace morphe::verify
