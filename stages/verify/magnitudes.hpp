#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/verify/violation_log.hpp"

namespace morphe::verify {

/// Records a `structure` violation for each magnitude that no valid plan has and that would make
/// the searches along a trajectory run practically without end. The limits are
/// - 1000 km for positions and lengths of the robot, the scene and the goals
/// - 1e6 rad or m for joint positions and limits, and for the offset of a coupled frame
/// - 1000 for the ratio of a coupled frame
/// - 6 hours for the trajectory
/// - 100,000 goal frames per second, and min(4,000,000, 1000 + 100 * samples) steps between goal
///   frames in the duration of the trajectory
/// Infinity is a violation; NaN is not. Returns false if there are any violations.
bool verify_magnitudes(const RobotModel& robot, const Plan& plan, ViolationLog& violations);
/// Checks a trajectory alone, which may be an approach or a retreat and must have samples.
bool verify_magnitudes(const Trajectory& trajectory, ViolationLog& violations);

}  // namespace morphe::verify
