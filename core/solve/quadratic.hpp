#pragma once

#include <Eigen/Core>

#include "core/motion/geometry.hpp"

namespace morphe::solve {

/// Local model of a sum of terms at a point: value, gradient and Hessian, which is positive
/// semidefinite (Gauss–Newton) or, if that was asked for, exact and then perhaps indefinite. A
/// least-squares term r(q) adds r², 2 Jᵀr and 2 JᵀJ.
struct Quadratic {
  double value = 0;
  JointVector gradient;     ///< [n]
  Eigen::MatrixXd hessian;  ///< [n, n], symmetric

  void reset(Eigen::Index n) {
    value = 0;
    gradient.setZero(n);
    hessian.setZero(n, n);
  }
  void scale(double factor) {
    value *= factor;
    gradient *= factor;
    hessian *= factor;
  }
};

}  // namespace morphe::solve
