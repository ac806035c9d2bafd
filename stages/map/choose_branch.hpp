#pragma once

#include <vector>

#include "core/robot/robot.hpp"

namespace morphe::map {

/// A continuous path through the whole movement.
struct CandidatePath {
  JointRows q;       ///< [F, n] joint positions
  double value = 0;  ///< sum of the frames' objectives and of the movement cost
};

/// Returns the index of the path with the least value in a branch (robot::branch_of_path). Among
/// the branches whose least value exceeds that of all by at most `share`, it is the one with the
/// fewest parts that differ from the branch of the reference posture [n]. Without a reference
/// (empty): the index of the least value. There must be a path.
std::size_t choose_branch(const robot::Robot& robot, const std::vector<CandidatePath>& paths,
                          const JointVector& reference, double share);

}  // namespace morphe::map
