#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/motion/robot_table.hpp"

namespace morphe::describe {

/// Two capsules that are checked, in `samples` positions drawn evenly from the joints' ranges.
struct SelfCollisionPair {
  std::array<int, 2> capsules{};
  int colliding = 0;   ///< samples in which they overlap
  double least_m = 0;  ///< least distance seen, < 0: overlap
};
struct SelfCollision {
  int samples = 0;
  std::vector<SelfCollisionPair> always, never, sometimes;  ///< in the order of the capsules
};

/// Pairs that overlap in every sample belong into `allowed_pairs`: they are made that way. Those
/// that never do may be put there to save time; samples prove nothing. The same robot gives the
/// same result.
SelfCollision sample_self_collision(const RobotTable& robot, int samples);

/// For a person, with lines for `allowed_pairs`.
std::string self_collision_text(const RobotTable& robot, const SelfCollision& found);
/// {samples, always: [[a, b]], never: [{pair, least_m}], sometimes: [{pair, share, least_m}]}
std::string self_collision_json(const RobotTable& robot, const SelfCollision& found);

}  // namespace morphe::describe
