#pragma once

#include <vector>

#include "core/solve/movement_problem.hpp"

namespace morphe::solve {

/// A movement at one point of the search, with the models of its frames.
struct MovementPoint {
  JointRows q;                    ///< [F, n]
  std::vector<Quadratic> models;  ///< [F]
  double frame_value = 0;         ///< sum over the frames
  double value = 0;               ///< including the differences
};

/// Computes all other members from `point.q`.
void evaluate(const MovementProblem& problem, MovementPoint& point);

/// Returns the gradient [F, n] of the whole objective.
JointRows gradient(const MovementProblem& problem, const MovementPoint& point);

/// The constant contribution of the differences to the Hessian: for each frame the diagonals of its
/// blocks with itself and the three frames before, [n, 4].
using DifferenceCurvature = std::vector<Eigen::MatrixXd>;
/// Computes the contribution of the differences.
DifferenceCurvature difference_curvature(const MovementProblem& problem);

/// Returns [F, n] (H + D) v, with H of frames and differences, and damping[f] on D's diagonal.
JointRows multiply(const DifferenceCurvature& between, const MovementPoint& point,
                   const JointVector& damping, const JointRows& v);

}  // namespace morphe::solve
