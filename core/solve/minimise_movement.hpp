#pragma once

#include "core/motion/key_bounds.hpp"
#include "core/solve/movement_problem.hpp"

namespace morphe::solve {

/// The options of minimise_movement().
struct MovementOptions {
  int max_iterations = 60;
  /// Stop if two consecutive accepted steps decrease the value by less than this share of it.
  double relative_tolerance = 1e-5;
};
/// Declares the config keys of the options.
template <class Fields>
void fields(Fields& f, MovementOptions& o) {
  f("max_iterations", o.max_iterations, bounds::kCount);
  f("relative_tolerance", o.relative_tolerance, bounds::kTolerance);
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
