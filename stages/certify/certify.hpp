#pragma once

#include "core/collision/world.hpp"
#include "core/motion/outcome.hpp"
#include "core/motion/plan.hpp"

namespace morphe::certify {

/// Certifies limits and contacts of a motion without goals, as certify() does. A target does not
/// move with the palm unless `world` has it attached already.
Outcome<Certificate> certify_motion(const collision::CollisionWorld& world, Trajectory& trajectory);

/// Certifies a trajectory as a controller executes it, along the quintic between samples:
///   limits     position, velocity, acceleration, jerk: exact extrema of every piece;
///   contacts   certified over the whole motion, not only at samples; a failure is
///              `smoothing_collision`, since the path is free before it is retimed;
///   tracking   tips against goals interpolated at the samples' demonstration times, and at least
///              every 2 ms between samples that are farther apart. The tolerance is
///              tracking_tolerance_grasp in grasp and hold, tracking_tolerance elsewhere.
/// Fills in the trajectory's clearance. Returns the certificate, also of a trajectory that fails;
/// the failure is the first of joint_limit, smoothing_collision and tracking, with the sample or
/// the time, the subject and the amount.
Outcome<Certificate> certify(const collision::CollisionWorld& world, const Goals& goals,
                             const Movement& movement, Trajectory& trajectory,
                             const MappingResult& mapped);

}  // namespace morphe::certify
