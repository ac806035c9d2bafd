#pragma once

#include <array>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::map {

/// An IK branch: a posture at a key frame, tracked to both ends of the movement.
struct IkBranch {
  /// Frame at which the branch was started.
  std::size_t key_frame = 0;
  JointRows q;                     ///< [F, n]
  std::vector<double> frame_cost;  ///< [F] objective of each frame
};

/// Returns the cheapest sequences through the key posture of every branch, found by the Viterbi
/// algorithm; a sequence may change between branches between any two frames. The cost is the sum of
/// the frames' costs, of the weighted differences along each branch (as in MovementProblem), and of
/// every change as a single step from one branch to the other:
///   sum over k = 1, 2, 3 and j of binomial(2k - 2, k - 1) difference_weight[k - 1][j] step_j².
/// Smoothing can only spread changes out. The cheapest sequence is first, and a sequence shared by
/// several branches is returned once.
std::vector<JointRows> join_ik_branches(const std::vector<IkBranch>& ways,
                                        const std::array<JointVector, 3>& difference_weight);

}  // namespace morphe::map
