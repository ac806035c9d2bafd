#pragma once

#include <array>
#include <functional>

#include "core/solve/quadratic.hpp"

namespace morphe::solve {

/// A whole movement as one problem: minimise, over q_1 … q_F within lower <= q_f <= upper,
///   sum_f F_f(q_f) + sum over k = 1, 2, 3, f and j of difference_weight[k - 1][j] (Δ^k q_f)_j²,
/// Δ^k the k-th forward difference: what velocity, acceleration and jerk cost.
struct MovementProblem {
  std::size_t frames = 0;
  JointVector lower, upper;                      ///< [n]
  std::array<JointVector, 3> difference_weight;  ///< [n] each
  /// Model of F_f at q, perhaps indefinite. `model` was reset to [n].
  std::function<void(std::size_t frame, const JointVector& q, Quadratic& model)> frame_model;
};

struct MovementOptions {
  int iterations = 60;
  double relative_value = 1e-5;  ///< stop when two steps in a row gain less than this share
};
template <class Fields>
void fields(Fields& f, MovementOptions& o) {
  f("iterations", o.iterations);
  f("relative_value", o.relative_value);
}

struct MovementMinimum {
  JointRows q;             ///< [F, n]
  double value = 0;        ///< with the smoothness penalty
  double frame_value = 0;  ///< sum of F_f alone
  int iterations = 0;
  bool converged = false;
};

/// Newton's method on the block-banded model: each step minimises within the bounds (a primal-dual
/// active set method) the model and D, a damping of every frame's own. The smoothness penalty is
/// quadratic, so that only the frames' own models can be wrong; D follows what each was wrong by.
/// A step that gains less than it promised is corrected before it is judged
/// (movement_correction.hpp): along a curved valley a good one leaves the floor. Deterministic.
MovementMinimum minimise_movement(const MovementProblem& problem, const JointRows& start,
                                  const MovementOptions& options);

}  // namespace morphe::solve
