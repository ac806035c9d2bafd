#pragma once

#include <cstdint>
#include <optional>

#include "stages/repair/interval_world.hpp"
#include "stages/repair/repair_options.hpp"

namespace morphe::repair {

/// An interval of a path, to be replanned between two samples that are free in `untimed`.
struct Interval {
  int first = 0, last = 0;  ///< indices of samples of the path
  IntervalWorld untimed;    ///< world for states that must be free at all times of the interval
  PaddedWorld timed;        ///< world with the same clearance, for states at a given time
};

/// Returns the interval around a finding from `begin_s` to `end_s`. It is `widen` samples wider on
/// each side, then extended to the nearest samples that are free with `extra_clearance` [m]. If
/// these are far, less clearance and contact with the target are tried too, and the shortest
/// interval is returned; nullopt if none ends at free samples.
std::optional<Interval> interval_around(const collision::CollisionWorld& world,
                                        const JointPath& path, double begin_s, double end_s,
                                        int widen, double extra_clearance);

/// Replaces the samples of `path` inside an interval by planned ones. A higher `attempt` (from 0)
/// searches a wider space. Returns false, with `path` unchanged, if no path was found.
bool plan_interval(const Interval& interval, const RepairOptions& options, int attempt,
                   std::uint64_t seed, JointPath& path);

}  // namespace morphe::repair
