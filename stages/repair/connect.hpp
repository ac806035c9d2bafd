#pragma once

#include <cstdint>
#include <vector>

#include "stages/repair/interval_world.hpp"

namespace morphe::repair {

/// Where the planner looks: `joints` move freely between `lower` and `upper`; all others go from
/// their start to their goal in one common proportion, which is planned as one more dimension.
struct ConnectSpace {
  std::vector<int> joints;
  JointVector lower, upper;  ///< of all joints [rad]
};

/// The joints between the base and the palm: those that carry the hand.
std::vector<int> arm_joints(const RobotTable& robot);

/// A polyline of certified edges from `from` to `to`, both included; empty if `iterations` of
/// RRT-Connect found none. Distances are in shares of each joint's span, `range` is the longest
/// edge. The same arguments give the same path on any thread.
std::vector<JointVector> connect(const IntervalWorld& interval, const ConnectSpace& space,
                                 const JointVector& from, const JointVector& to, int iterations,
                                 double range, std::uint64_t seed);

}  // namespace morphe::repair
