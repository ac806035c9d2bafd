#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::solve {

/// H + damping I = sum over p of s_p s_pᵀ, s_p without entries after p, and without the rows and
/// columns of variables that are held. Eliminated from the last variable to the first, so that in a
/// tree whose parents come first (a robot: arm, then fingers) no entry appears that H does not
/// have, and rows that a pivot does not meet cost nothing. Any symmetric positive definite H will
/// do; a full one costs n³/3. No allocation after the first call.
class EnvelopeCholesky {
 public:
  double missing = 0;     ///< where factorise failed: at least so much more damping is needed
  JointVector direction;  ///< and along this
  double curvature = 0;   ///< H + damping I is so curved

  /// False if a pivot is not clearly positive: then nothing can be solved. Of H the upper triangle
  /// is read.
  bool factorise(const Eigen::MatrixXd& hessian, double damping, const std::vector<char>& held);
  /// right_side becomes the solution; a held variable's entry stays what it is.
  void solve(JointVector& right_side) const;

 private:
  double squared_length_at(Eigen::Index pivot);
  Eigen::Map<const JointVector> before(Eigen::Index pivot, Eigen::Index from = 0) const;

  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows;  ///< s_p, padded
  JointVector inverse_pivot;
};

}  // namespace morphe::solve
