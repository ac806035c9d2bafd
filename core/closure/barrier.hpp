#pragma once

#include <Eigen/Core>

namespace morphe::closure {

/// min 1/2 x^T H x + g^T x over x in R^n with |x_{4k+1 … 4k+3}| <= x_{4k} for each of the first
/// `cones` fours, rows x <= most, and |A x + b| <= x_{n-1}. H is positive semidefinite.
struct BarrierProblem {
  Eigen::Index cones = 0;
  Eigen::MatrixXd hessian;                ///< [n, n]
  Eigen::VectorXd gradient;               ///< [n]
  Eigen::MatrixXd rows;                   ///< [m, n]
  Eigen::VectorXd most;                   ///< [m]
  Eigen::MatrixXd rest;                   ///< A [6, n]; its last column is 0
  Eigen::Matrix<double, 6, 1> rest_at_0;  ///< b
};

/// Newton's method on t times what is minimised, less the logarithms of what the constraints leave,
/// t growing tenfold to 1e6 (Boyd and Vandenberghe 2004, chapter 11), from an x inside all
/// constraints, which stays inside. False where the last t's steps, at most 50, did not settle it.
bool minimise_inside(const BarrierProblem& problem, Eigen::VectorXd& x);

}  // namespace morphe::closure
