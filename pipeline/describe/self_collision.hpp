#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/motion/robot_model.hpp"

namespace morphe::describe {

/// Two capsules, and their distance in `samples` uniformly distributed joint positions.
struct SelfCollisionPair {
  std::array<int, 2> capsules{};
  int colliding_samples = 0;  ///< number of positions in which they overlap
  double distance_m = 0;      ///< smallest over all positions, negative for an overlap
};
/// The pairs of capsules, classified by their overlap.
struct SelfCollision {
  int samples = 0;  ///< number of joint positions
  /// The pairs that always, never and sometimes overlap, in the order of the capsules.
  std::vector<SelfCollisionPair> always, never, sometimes;
};

/// Checks the robot's pairs of capsules in random joint positions. Pairs that overlap in every
/// position belong in `allowed_collision_pairs`, because they overlap by design. Pairs that never
/// overlap may be added there to save time, but it is not proved that they cannot overlap.
SelfCollision sample_self_collision(const RobotModel& robot, int samples);

/// Returns a text for display, with lines for `allowed_collision_pairs`.
std::string self_collision_text(const RobotModel& robot, const SelfCollision& found);
/// Returns JSON: samples, always: [pair], never: [{pair, least_m}], sometimes: [{…, share}].
std::string self_collision_json(const RobotModel& robot, const SelfCollision& found);

}  // namespace morphe::describe
