#pragma once

#include <memory>
#include <vector>

#include "pipeline/collision/certified.hpp"

namespace morphe {

/// What the states of a planned interval must keep clear of. They have no time of their own: each
/// must be free at all of `times`. A target that moves within the interval is left out, since no
/// state could hold it all the time.
struct IntervalWorld {
  CollisionWorld world;                ///< in which `scene` is the one below
  std::shared_ptr<const Scene> scene;  ///< keeps it alive
  std::vector<double> times;           ///< demonstration time [s]
};

/// Where an interval reaches beyond the time in which the target may be touched: `strict` forbids
/// touching in all of it, `lenient` allows it in all of it (the check of the whole path decides).
enum class TouchRule { strict, lenient };

/// A world with `extra_m` more clearance than the margin; half the contact depth at least is left.
CollisionWorld with_extra_clearance(const CollisionWorld& world, double extra_m);

IntervalWorld interval_world(const CollisionWorld& world, double begin_s, double end_s,
                             double extra_m, TouchRule rule);

bool state_free(const IntervalWorld& interval, const JointVector& q, CollisionScratch& scratch);

/// Certified: free all along the straight line.
bool line_free(const IntervalWorld& interval, const JointRows& reach, const JointVector& from,
               const JointVector& to, CollisionScratch& scratch);

}  // namespace morphe
