#pragma once

#include <memory>
#include <vector>

#include "core/collision/certified.hpp"

namespace morphe::repair {

/// A world with more clearance than the margin; within the hand with 0.2 mm more at most: fingers
/// lie within millimetres of each other in every posture.
struct ClearWorld {
  collision::CollisionWorld around;    ///< all pairs but those within the hand
  collision::CollisionWorld hand;      ///< those within the hand, no objects
  std::shared_ptr<const Scene> scene;  ///< what `around` looks at
  std::shared_ptr<const Scene> nothing;
};

/// `extra_m` more than the margin; half the contact depth at least is left.
ClearWorld clear_world(const collision::CollisionWorld& world, double extra_m);

/// Certified: free all along the straight line, while time goes from from_s to to_s.
bool line_free(const ClearWorld& world, const JointVector& from, const JointVector& to,
               double from_s, double to_s, collision::CollisionScratch& scratch);

/// What the states of a planned interval must keep clear of. They have no time of their own: each
/// must be free at all of `times`. A target that moves within the interval is left out, since no
/// state could hold it all the time.
struct IntervalWorld {
  ClearWorld world;
  std::vector<double> times;  ///< demonstration time [s]
};

/// Where an interval reaches beyond the time in which the target may be touched: `strict` forbids
/// touching in all of it, `lenient` allows it in all of it (the check of the whole path decides).
enum class TouchRule { strict, lenient };

IntervalWorld interval_world(const collision::CollisionWorld& world, double begin_s, double end_s,
                             double extra_m, TouchRule rule);

bool state_free(const IntervalWorld& interval, const JointVector& q,
                collision::CollisionScratch& scratch);

/// Certified: free all along the straight line.
bool line_free(const IntervalWorld& interval, const JointVector& from, const JointVector& to,
               collision::CollisionScratch& scratch);

}  // namespace morphe::repair
