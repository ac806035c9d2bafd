#pragma once

#include <Eigen/Core>

namespace morphe::closure {

/// The problem min 1/2 x^T H x + g^T x over x in R^n, subject to |x_{4k+1 … 4k+3}| <= x_{4k} for
/// each of the first `cones` groups of four variables, rows x <= row_bounds, and |A x + b| <=
/// x_{n-1}. H is positive semidefinite.
struct BarrierProblem {
  Eigen::Index cones = 0;
  Eigen::MatrixXd hessian;                      ///< [n, n]
  Eigen::VectorXd gradient;                     ///< [n]
  Eigen::MatrixXd rows;                         ///< [m, n]
  Eigen::VectorXd row_bounds;                   ///< [m]
  Eigen::MatrixXd residual_matrix;              ///< A [6, n]; its last column is 0
  Eigen::Matrix<double, 6, 1> residual_offset;  ///< b
};

/// Solves the problem by a barrier method: Newton's method on t times the objective minus the
/// logarithms of the constraints' slacks, with t increasing tenfold from 1 to 1e6 (Boyd and
/// Vandenberghe 2004, chapter 11). The initial x must be strictly feasible, and x remains so.
/// Returns false if Newton's method does not converge for the last t.
bool minimise_with_barrier(const BarrierProblem& problem, Eigen::VectorXd& x);

}  // namespace morphe::closure
