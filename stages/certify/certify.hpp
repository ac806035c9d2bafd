#pragma once

#include <string>

#include "pipeline/collision/world.hpp"
#include "pipeline/motion/plan.hpp"

namespace morphe::certify {

struct CertifyResult {
  Certificate certificate;       ///< filled in as far as it could be, also if something fails
  Reason reason = Reason::none;  ///< all of it holds; or limit, smoothing, collision, tracking
  std::string detail;            ///< a sentence with sample or time, what and how much
};

/// The limits and contacts alone, for a motion without goals. The world stands as it is.
CertifyResult certify_motion(const collision::CollisionWorld& world, Trajectory& trajectory,
                             bool path_was_free = true);

/// What holds for a trajectory as a controller runs it, the quintic between samples:
///   limits     position, velocity, acceleration, jerk: exact extremes of every piece;
///   contacts   certified over the whole motion, not only at samples; a failure is `smoothing` if
///              the path was certified free before retiming (`path_was_free`), else `collision`;
///   tracking   tips against goals interpolated at the samples' demonstration times, with
///              tracking_grasp in the phases grasp and hold and tracking elsewhere.
/// Fills in the trajectory's clearance. The first failure in this order is the reason.
CertifyResult certify(const collision::CollisionWorld& world, const Goals& goals,
                      const Movement& movement, Trajectory& trajectory, const Mapped& mapped,
                      bool path_was_free = true);

}  // namespace morphe::certify
