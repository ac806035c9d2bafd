#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"
#include "stages/verify/violation_runs.hpp"

namespace morphe::verify {

/// Whether status and content go together, shapes fit, numbers are numbers, time runs on from 0 and
/// demonstration_time never back; the trajectory must lead through the goals' time, to 1e-6 s, and
/// no finding may remain; magnitudes are those of a plan (magnitudes.hpp). Notes `structure`,
/// `finite` and `time`. False if the motion cannot be judged any further.
bool judge_structure(const RobotTable& robot, const Plan& plan, ViolationRuns& runs);

/// The same for an approach or a retreat, which have no goals: its last (`at_its_end`) or first
/// sample is where the trajectory begins or ends, to kTransferEnd. False also if there is none.
bool judge_transfer_structure(const RobotTable& robot, const Plan& plan, const Trajectory& transfer,
                              bool at_its_end, ViolationRuns& runs);

}  // namespace morphe::verify
