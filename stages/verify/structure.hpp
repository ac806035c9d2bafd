#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/verify/violation_log.hpp"

namespace morphe::verify {

/// Records `structure`, `finite` and `time` violations. Status and content must be consistent,
/// shapes match, numbers be finite, time increase from 0 and demonstration_time never decrease. The
/// trajectory must begin and end with the goals, to 1e-6 s. No finding may remain. Magnitudes must
/// be those of a valid plan (magnitudes.hpp). Returns false if there is no trajectory, or if it
/// cannot be verified any further.
bool verify_structure(const RobotModel& robot, const Plan& plan, ViolationLog& violations);

/// Checks the arrays and magnitudes of an approach, whose last sample must be the trajectory's
/// first to kJunctionTolerance, or of a retreat, whose first sample must be the trajectory's last.
/// Returns false if there is no such motion, or if it cannot be verified any further.
bool verify_approach_retreat_structure(const RobotModel& robot, const Plan& plan,
                                       const Trajectory& motion, bool is_approach,
                                       ViolationLog& violations);

}  // namespace morphe::verify
