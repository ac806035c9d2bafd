#pragma once

#include <vector>

#include "core/motion/robot_table.hpp"

namespace morphe::setup {

/// Two frames whose capsules are not checked against each other, and why.
struct AllowedPair {
  int one = -1, other = -1;
  double share = 0;      ///< of the sampled postures in which they overlap
  double deepest_m = 0;  ///< overlap at rest
};

/// Overlap: less than 1.5 mm apart, which a margin of 1 mm cannot stand.
/// Frames with capsules that no joint connects directly and that overlap in more than 95 % of 400
/// postures of the joints between them, drawn from a seed of their own: they are made that way. So
/// are those with at most three joints between them that overlap at rest (all joints as near to
/// zero as they may be) by more than 4 mm. So are parts that one
/// joint moves both of, each its own way, if they ever overlap: the bars of a gripper, which a URDF
/// cuts open. Everything else stays checked: that samples found no
/// contact proves nothing. Pairs that the table allows already are left out.
std::vector<AllowedPair> allowed_links(const RobotTable& robot);

}  // namespace morphe::setup
