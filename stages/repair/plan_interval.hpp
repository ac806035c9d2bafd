#pragma once

#include <cstdint>
#include <optional>

#include "stages/repair/interval_world.hpp"
#include "stages/repair/repair_options.hpp"

namespace morphe::repair {

/// Samples `first` and `last` of a path are free in `within`; what lies between is planned anew.
struct Interval {
  int first = 0, last = 0;
  IntervalWorld within;
  ClearWorld timed;  ///< with the same clearance, for states that have their time
};

/// The interval around a finding: `widen` samples wider on each side, then on to the nearest
/// samples that are free with the extra clearance. Where these are far, less clearance or touching
/// of the target is tried. None if a side has no free sample.
std::optional<Interval> interval_around(const collision::CollisionWorld& world,
                                        const JointPath& path, double begin_s, double end_s,
                                        int widen, double extra_clearance);

/// Plans the samples inside an interval (Origin::planned); `attempt` (0, 1, …) widens the space
/// that is searched. False, and nothing changed, if no path was found.
bool plan_interval(const Interval& interval, const RepairOptions& options, int attempt,
                   std::uint64_t seed, JointPath& path);

}  // namespace morphe::repair
