#pragma once

#include <array>
#include <functional>

#include "core/solve/quadratic.hpp"

namespace morphe::solve {

/// A whole movement as one problem: minimise, over q_1 … q_F with lower <= q_f <= upper,
///   sum_f F_f(q_f) + sum over k = 1, 2, 3, f and j of difference_weight[k - 1][j] (Δ^k q_f)_j²,
/// in which Δ^k, the k-th forward difference, penalises velocity, acceleration and jerk.
struct MovementProblem {
  Eigen::Index frames = 0;
  JointVector lower, upper;                      ///< [n]
  std::array<JointVector, 3> difference_weight;  ///< [n] each
  /// Computes the model of F_f at q, possibly indefinite. `model` was reset to [n].
  std::function<void(Eigen::Index frame, const JointVector& q, Quadratic& model)> frame_model;
};

}  // namespace morphe::solve
