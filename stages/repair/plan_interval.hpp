#pragma once

#include <cstdint>
#include <optional>

#include "stages/repair/interval_world.hpp"
#include "stages/repair/repair_options.hpp"

namespace morphe::repair {

/// An interval of a path that is to be replanned. Its samples `first` and `last` are free in
/// `untimed_world`; those between them are planned.
struct Interval {
  int first = 0, last = 0;      ///< indices of samples of the path
  IntervalWorld untimed_world;  ///< for states that must be free at all times
  PaddedWorld timed_world;      ///< the same clearance, for states with a time of their own
};

/// Returns the interval around a finding: `widen` samples wider on each side, then extended to the
/// nearest samples that are free with the extra clearance. If these are far, less clearance or
/// contact with the target is tried. Returns nullopt if one side has no free sample.
std::optional<Interval> interval_around(const collision::CollisionWorld& world,
                                        const JointPath& path, double begin_s, double end_s,
                                        int widen, double extra_clearance);

/// Plans the samples inside an interval (SampleOrigin::planned); `attempt` (0, 1, …) widens the
/// search space. Returns false and leaves the path unchanged if no path was found.
bool plan_interval(const Interval& interval, const RepairOptions& options, int attempt,
                   std::uint64_t seed, JointPath& path);

}  // namespace morphe::repair
