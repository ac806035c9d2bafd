#pragma once

#include <array>
#include <functional>

#include "core/solve/quadratic.hpp"

namespace morphe::solve {

/// A whole movement as one problem: minimise, over q_1 … q_F with lower <= q_f <= upper,
///   sum_f F_f(q_f) + sum over k = 1, 2, 3, f and j of difference_weight[k - 1][j] (Δ^k q_f)_j²,
/// in which Δ^k, the k-th forward difference, penalises velocity, acceleration and jerk.
struct MovementProblem {
  std::size_t frames = 0;
  JointVector lower, upper;                      ///< [n]
  std::array<JointVector, 3> difference_weight;  ///< [n] each
  /// Computes the model of F_f at q, possibly indefinite. `model` was reset to [n].
  std::function<void(std::size_t frame, const JointVector& q, Quadratic& model)> frame_model;
};

/// The options of minimise_movement().
struct MovementOptions {
  int max_iterations = 60;
  /// Stop if two consecutive steps decrease the value by less than this share.
  double relative_tolerance = 1e-5;
};
/// Declares the config keys of the options.
template <class Fields>
void fields(Fields& f, MovementOptions& o) {
  f("max_iterations", o.max_iterations);
  f("relative_tolerance", o.relative_tolerance);
}

/// The result of minimise_movement().
struct MovementMinimum {
  JointRows q;             ///< [F, n]
  double value = 0;        ///< including the smoothness penalty
  double frame_value = 0;  ///< sum of F_f without the penalty
  int iterations = 0;
  bool converged = false;
};

/// Minimises a movement by Newton's method on the block-banded model: each step minimises, within
/// the bounds (a primal-dual active set method), the model plus D, a separate damping of every
/// frame. The smoothness penalty is quadratic, so only the models of the frames can be inaccurate;
/// D is adapted to the error of each. A step that decreases the value less than predicted is
/// corrected before it is assessed (movement_correction.hpp), because along a curved valley a good
/// step leaves the bottom. Deterministic.
MovementMinimum minimise_movement(const MovementProblem& problem, const JointRows& start,
                                  const MovementOptions& options);

}  // namespace morphe::solve
