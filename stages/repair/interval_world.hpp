#pragma once

#include <memory>
#include <vector>

#include "core/collision/continuous_check.hpp"

namespace morphe::repair {

/// A collision world with a clearance larger than the margin; within the hand by at most 0.2 mm,
/// because the fingers are within millimetres of each other in every posture.
struct PaddedWorld {
  collision::CollisionWorld environment;  ///< all pairs except those within the hand
  collision::CollisionWorld hand;         ///< the pairs within the hand, without objects
  std::shared_ptr<const Scene> scene;     ///< scene of `environment`
  std::shared_ptr<const Scene> empty_scene;
};

/// Returns the world with the margin increased by `extra_m`; at least half of the contact depth
/// remains.
PaddedWorld padded_world(const collision::CollisionWorld& world, double extra_m);

/// Returns true if the motion along the straight line is certified to be free while the
/// demonstration time advances from from_s to to_s.
bool is_motion_free(const PaddedWorld& world, const JointVector& from, const JointVector& to,
                    double from_s, double to_s, collision::CollisionScratch& scratch);

/// The world of a planned interval. Its states have no time of their own; each must be free at all
/// of `times`. A target that moves within the interval is omitted, since no state could hold it at
/// all times.
struct IntervalWorld {
  PaddedWorld world;
  std::vector<double> times;  ///< demonstration time [s]
};

/// The rule for an interval that extends beyond the time in which the target may be touched:
/// `strict` forbids contact in the whole interval, `lenient` allows it in the whole interval (the
/// check of the whole path decides).
enum class TouchRule { strict, lenient };

/// Returns the world of an interval of demonstration time.
IntervalWorld interval_world(const collision::CollisionWorld& world, double begin_s, double end_s,
                             double extra_m, TouchRule rule);

/// Returns true if a state is free at all times of the interval.
bool is_state_free(const IntervalWorld& interval, const JointVector& q,
                   collision::CollisionScratch& scratch);

/// Returns true if the straight line is certified to be free at all times of the interval.
bool is_motion_free(const IntervalWorld& interval, const JointVector& from, const JointVector& to,
                    collision::CollisionScratch& scratch);

}  // namespace morphe::repair
