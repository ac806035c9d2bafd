#pragma once

#include <Eigen/Core>

#include "core/motion/geometry.hpp"

namespace morphe::solve {

/// A local quadratic model of a sum of terms: value, gradient and Hessian, positive semidefinite
/// (Gauss–Newton) or exact. A least-squares term r(q) adds r², 2 Jᵀr and 2 JᵀJ.
struct Quadratic {
  double value = 0;
  JointVector gradient;     ///< [n]
  Eigen::MatrixXd hessian;  ///< [n, n], symmetric

  /// Sets the model to zero, with n variables.
  void reset(Eigen::Index n) {
    value = 0;
    gradient.setZero(n);
    hessian.setZero(n, n);
  }
  /// Multiplies the model by a factor.
  void scale(double factor) {
    value *= factor;
    gradient *= factor;
    hessian *= factor;
  }
};

}  // namespace morphe::solve
