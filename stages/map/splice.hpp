#pragma once

#include <array>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::map {

/// A posture at a key frame, followed to both ends of the movement.
struct Way {
  std::size_t key = 0;
  JointRows q;                ///< [F, n]
  std::vector<double> value;  ///< [F] what each frame costs
};

/// The cheapest sequence through every way's key posture, which may change from way to way between
/// any two frames (Viterbi): sum of the frames' costs, of the weighted differences along each way
/// (as in MovementProblem), and of every change by itself, a step from one way to the other:
///   sum over k = 1, 2, 3 and j of binomial(2k - 2, k - 1) difference_weight[k - 1][j] step_j².
/// Smoothing can only spread changes out. The cheapest first, a sequence that several ways share
/// once.
std::vector<JointRows> splice(const std::vector<Way>& ways,
                              const std::array<JointVector, 3>& difference_weight);

}  // namespace morphe::map
