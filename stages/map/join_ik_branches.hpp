#pragma once

#include <array>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::map {

/// An IK branch: a posture at a key frame, tracked to both ends of the movement.
struct IkBranch {
  Eigen::Index key_frame = 0;
  JointRows q;                     ///< [F, n]
  std::vector<double> frame_cost;  ///< [F] objective of each frame
};

/// Returns for each branch the cheapest sequence [F, n] that passes its key posture; a sequence may
/// change branches between any two frames (Viterbi algorithm). Its cost is the sum of
///   frame_cost over all frames,
///   the weighted differences along each branch (as in MovementProblem), and
///   the step of each change, which smoothing can only spread out: the sum over k = 1, 2, 3 and j
///   of
///     binomial(2k - 2, k - 1) difference_weight[k - 1][j] step_j².
/// The cheapest sequence is first. A sequence that several branches share is returned once.
std::vector<JointRows> join_ik_branches(const std::vector<IkBranch>& branches,
                                        const std::array<JointVector, 3>& difference_weight);

}  // namespace morphe::map
