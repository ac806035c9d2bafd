#pragma once

#include <cstdint>
#include <vector>

#include "stages/repair/interval_world.hpp"

namespace morphe::repair {

/// The search space. `joints` move freely; each other joint has made the same share of its change
/// from start to goal, which is one more dimension.
struct ConnectSpace {
  std::vector<int> joints;   ///< not empty
  JointVector lower, upper;  ///< limits of all joints [rad]
};

/// Plans with RRT-Connect. Returns a polyline of certified edges from `from` to `to`, both
/// included; empty if `iterations` did not find one. Distances are measured in shares of each
/// joint's span; `range` is the length of the longest edge. The same arguments give the same path
/// on any thread.
std::vector<JointVector> plan_rrt_connect(const IntervalWorld& interval, const ConnectSpace& space,
                                          const JointVector& from, const JointVector& to,
                                          int iterations, double range, std::uint64_t seed);

}  // namespace morphe::repair
