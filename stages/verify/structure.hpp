#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/verify/violation_collector.hpp"

namespace morphe::verify {

/// Checks that status and content are consistent, shapes match, numbers are finite, time increases
/// from 0 and demonstration_time never decreases; the trajectory must cover the goals' time, to
/// 1e-6 s, and no finding may remain; magnitudes must be those of a valid plan (magnitudes.hpp).
/// Records `structure`, `finite` and `time` violations. Returns false if the motion cannot be
/// verified any further.
bool verify_structure(const RobotModel& robot, const Plan& plan, ViolationCollector& runs);

/// Checks the same for an approach or a retreat, which have no goals: its last (`at_its_end`) or
/// first sample must coincide with the trajectory's begin or end, to kJunctionTolerance. Returns
/// false also if there is no such motion.
bool verify_approach_retreat_structure(const RobotModel& robot, const Plan& plan,
                                       const Trajectory& transfer, bool at_its_end,
                                       ViolationCollector& runs);

}  // namespace morphe::verify
