#pragma once

#include <vector>

#include "core/solve/minimise_movement.hpp"

namespace morphe::solve {

/// A movement at one point of its search: the frames' own models there.
struct MovementPoint {
  JointRows q;                    ///< [F, n]
  std::vector<Quadratic> models;  ///< [F]
  double frame_value = 0;         ///< sum of the frames' own
  double value = 0;               ///< with the differences'
};

/// Fills everything else from `point.q`.
void evaluate(const MovementProblem& problem, MovementPoint& point);

/// [F, n] of the whole value.
JointRows gradient(const MovementProblem& problem, const MovementPoint& point);

/// What the differences add to the Hessian, anywhere: for each frame the diagonals of its blocks
/// with itself and the three frames before, [n, 4].
using DifferenceCurvature = std::vector<Eigen::MatrixXd>;
DifferenceCurvature difference_curvature(const MovementProblem& problem);

/// [F, n] (H + D) v, H = the frames' Hessians and the differences', D = damping[f] on the diagonal
/// of frame f.
JointRows multiply(const DifferenceCurvature& between, const MovementPoint& point,
                   const JointVector& damping, const JointRows& v);

}  // namespace morphe::solve
