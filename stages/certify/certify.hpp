#pragma once

#include "core/collision/world.hpp"
#include "core/motion/outcome.hpp"
#include "core/motion/plan.hpp"

namespace morphe::certify {

/// Certifies limits and contacts only, for a motion without goals. The world remains as it is.
Outcome<Certificate> certify_motion(const collision::CollisionWorld& world, Trajectory& trajectory,
                                    bool path_was_free = true);

/// Certifies a trajectory as a controller executes it, along the quintic between samples:
///   limits     position, velocity, acceleration, jerk: exact extrema of every piece;
///   contacts   certified over the whole motion, not only at samples; a failure is `smoothing` if
///              the path was certified free before retiming (`path_was_free`), else `collision`;
///   tracking   tips against goals interpolated at the samples' demonstration times, and every 2 ms
///              between samples that are farther apart, with tracking_grasp in the phases grasp and
///              hold and tracking elsewhere.
/// Fills in the trajectory's clearance, and the certificate as far as possible. Refuses with the
/// reason limit, smoothing, collision or tracking, the first that fails in this order, with the
/// sample or the time, the subject and the amount.
Outcome<Certificate> certify(const collision::CollisionWorld& world, const Goals& goals,
                             const Movement& movement, Trajectory& trajectory,
                             const MappingResult& mapped, bool path_was_free = true);

}  // namespace morphe::certify
