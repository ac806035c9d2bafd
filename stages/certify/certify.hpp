#pragma once

#include "core/collision/world.hpp"
#include "core/motion/outcome.hpp"
#include "core/motion/plan.hpp"

namespace morphe::certify {

/// The limits and contacts alone, for a motion without goals. The world stands as it is.
Outcome<Certificate> certify_motion(const collision::CollisionWorld& world, Trajectory& trajectory,
                                    bool path_was_free = true);

/// What holds for a trajectory as a controller runs it, the quintic between samples:
///   limits     position, velocity, acceleration, jerk: exact extremes of every piece;
///   contacts   certified over the whole motion, not only at samples; a failure is `smoothing` if
///              the path was certified free before retiming (`path_was_free`), else `collision`;
///   tracking   tips against goals interpolated at the samples' demonstration times, and every 2 ms
///              between samples that are farther apart, with tracking_grasp in the phases grasp and
///              hold and tracking elsewhere.
/// Fills in the trajectory's clearance, and the certificate as far as it can be. Refused: limit,
/// smoothing, collision, tracking, the first that fails in this order, with sample or time, what
/// and how much.
Outcome<Certificate> certify(const collision::CollisionWorld& world, const Goals& goals,
                             const Movement& movement, Trajectory& trajectory, const Mapped& mapped,
                             bool path_was_free = true);

}  // namespace morphe::certify
