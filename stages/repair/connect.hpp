#pragma once

#include <cstdint>
#include <vector>

#include "stages/repair/interval_world.hpp"

namespace morphe::repair {

/// The search space of the planner: `joints` move freely between `lower` and `upper`; all others
/// move from their start to their goal in one common proportion, which is planned as one additional
/// dimension.
struct ConnectSpace {
  std::vector<int> joints;   ///< joints that move freely
  JointVector lower, upper;  ///< limits of all joints [rad]
};

/// Returns the joints between the base and the palm, which are those that move the hand.
std::vector<int> arm_joints(const RobotModel& robot);

/// Plans with RRT-Connect. Returns a polyline of certified edges from `from` to `to`, both
/// included; empty if `iterations` did not find one. Distances are measured in shares of each
/// joint's span; `range` is the longest edge. The same arguments give the same path on any thread.
std::vector<JointVector> plan_rrt_connect(const IntervalWorld& interval, const ConnectSpace& space,
                                          const JointVector& from, const JointVector& to,
                                          int iterations, double range, std::uint64_t seed);

}  // namespace morphe::repair
