#pragma once

#include "core/collision/world.hpp"
#include "core/motion/outcome.hpp"
#include "core/motion/plan.hpp"

namespace morphe::certify {

/// Certifies limits and contacts only, for a motion without goals. The world remains as it is.
Outcome<Certificate> certify_motion(const collision::CollisionWorld& world, Trajectory& trajectory);

/// Certifies a trajectory as a controller executes it, along the quintic between samples:
///   limits     position, velocity, acceleration, jerk: exact extrema of every piece;
///   contacts   certified over the whole motion, not only at samples; a failure is
///              `smoothing_collision`, since the path is free before it is retimed;
///   tracking   tips against goals interpolated at the samples' demonstration times, and every 2 ms
///              between samples that are farther apart, with tracking_tolerance_grasp in the phases
///              grasp and hold and tracking elsewhere.
/// Fills in the trajectory's clearance, and the certificate except for `repaired` and
/// `natural_posture_error`, which the caller knows. Refuses with the reason joint_limit,
/// smoothing_collision or tracking, the first that fails in this order, with the sample or the
/// time, the subject and the amount.
Outcome<Certificate> certify(const collision::CollisionWorld& world, const Goals& goals,
                             const Movement& movement, Trajectory& trajectory,
                             const MappingResult& mapped);

}  // namespace morphe::certify
