#pragma once

#include <memory>
#include <vector>

#include "core/collision/continuous_check.hpp"

namespace morphe::repair {

/// A collision world with extra clearance, of which there is little within the hand because its
/// fingers are always close to each other.
struct PaddedWorld {
  collision::CollisionWorld environment;  ///< all pairs except those within the hand
  collision::CollisionWorld hand;         ///< the pairs within the hand, without objects
  std::shared_ptr<const Scene> scene;     ///< scene of `environment`
  std::shared_ptr<const Scene> empty_scene;
};

/// Returns the world with `extra_m` more clearance, within the hand at most
/// kMaxExtraHandClearance_m. At least half of the permitted penetration remains.
PaddedWorld padded_world(const collision::CollisionWorld& world, double extra_m);

/// Returns true if the straight line from `from` to `to` is certified to be free while the
/// demonstration time advances from `from_s` to `to_s`.
bool is_motion_free(const PaddedWorld& world, const JointVector& from, const JointVector& to,
                    double from_s, double to_s, collision::CollisionScratch& scratch);

/// The world of an interval, whose states must be free at all of `times`. A target that is attached
/// in the whole interval moves with the robot. One that moves otherwise is left out.
struct IntervalWorld {
  PaddedWorld world;
  std::vector<double> times;  ///< demonstration time [s]; only the begin if no object moves
};

/// The rule for an interval that is only partly within the time in which the hand may touch the
/// target, or a carried target its support: they may do so at no time of the interval (strict) or
/// at all times (lenient).
enum class TouchRule { strict, lenient };

/// Returns the world of an interval of demonstration time with `extra_m` more clearance.
IntervalWorld interval_world(const collision::CollisionWorld& world, double begin_s, double end_s,
                             double extra_m, TouchRule rule);

/// Returns true if a state is free at all times of the interval.
bool is_state_free(const IntervalWorld& interval, const JointVector& q,
                   collision::CollisionScratch& scratch);

/// Returns true if the straight line is certified to be free at all times of the interval.
bool is_motion_free(const IntervalWorld& interval, const JointVector& from, const JointVector& to,
                    collision::CollisionScratch& scratch);

}  // namespace morphe::repair
