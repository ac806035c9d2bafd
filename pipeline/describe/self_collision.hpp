#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/motion/robot_model.hpp"

namespace morphe::describe {

/// Two capsules that are checked against each other, in `samples` positions drawn uniformly from
/// the ranges of the joints.
struct SelfCollisionPair {
  /// The indices of the capsules.
  std::array<int, 2> capsules{};
  /// Number of samples in which they overlap.
  int colliding_samples = 0;
  /// Smallest distance, negative for an overlap [m].
  double least_m = 0;
};
/// The pairs of capsules, classified by their overlap.
struct SelfCollision {
  /// The number of samples.
  int samples = 0;
  /// The pairs that always, never and sometimes overlap, in the order of the capsules.
  std::vector<SelfCollisionPair> always, never, sometimes;
};

/// Samples the self-collision of a robot. Pairs that overlap in every sample belong in
/// `allowed_collision_pairs`, because they overlap by design. Pairs that never overlap may be added
/// there to save time, but samples do not prove that they cannot. Equal robots give equal results.
SelfCollision sample_self_collision(const RobotModel& robot, int samples);

/// Returns a text for display, with lines for `allowed_collision_pairs`.
std::string self_collision_text(const RobotModel& robot, const SelfCollision& found);
/// Returns {samples, always: [[a, b]], never: [{pair, least_m}], sometimes: [{pair, share,
/// least_m}]}.
std::string self_collision_json(const RobotModel& robot, const SelfCollision& found);

}  // namespace morphe::describe
