#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"
#include "stages/verify/violation_runs.hpp"

namespace morphe::verify {

/// Notes `mapped` for frames whose figures are not those of their posture and goals, once each, at
/// the worst frame: position_error [m], orientation_error [rad] and the sum A of humanlikeness, to
/// 1e-6; status, by the tips within 1 mm of their goals and what is called in reach; position where
/// frames are missing, or no numbers. Objective, B and C are the mapping's own business: no more is
/// asked of them than to be numbers.
void judge_mapped(const RobotTable& robot, const Plan& plan, ViolationRuns& runs);

}  // namespace morphe::verify
