#pragma once

#include <vector>

#include "core/motion/robot_model.hpp"

namespace morphe::setup {

/// Two frames whose capsules are not checked against each other, and the reasons.
struct AllowedPair {
  /// The indices of the frames.
  int first = -1, second = -1;
  /// Share of the sampled postures in which they overlap.
  double share = 0;
  /// Overlap at rest [m].
  double rest_penetration_m = 0;
};

/// Finds the pairs of frames with capsules whose collision is allowed. Two frames overlap if they
/// are less than 1.5 mm apart, which is incompatible with a margin of 1 mm. A pair is allowed if no
/// joint connects it directly and
///   - it overlaps in more than 95 % of 400 postures of the joints between the frames, sampled from
///     a fixed seed for each pair, which indicates that the frames overlap by design; or
///   - it has at most three joints between its frames and overlaps at rest (all joints as near to
///     zero as possible) by more than 4 mm; or
///   - both frames are moved by one joint, each in its own way, and they overlap in any posture,
///     for example the bars of a gripper, whose loop a URDF cuts open.
/// All other pairs remain checked, because samples without contact do not prove its absence. Pairs
/// that the table already allows are left out.
std::vector<AllowedPair> find_allowed_links(const RobotModel& robot);

}  // namespace morphe::setup
