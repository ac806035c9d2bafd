#pragma once

#include <Eigen/Core>
#include <vector>

#include "pipeline/motion/geometry.hpp"

namespace morphe::solve {

/// H + damping I = Lᵀ L without the rows and columns of variables that are held. Eliminated from
/// the last variable to the first, so that in a tree whose parents come first (a robot: arm, then
/// fingers) no entry appears that H does not have: rows begin at their first nonzero. Any symmetric
/// positive definite H will do; a full one costs n³/6. No allocation after the first call.
class EnvelopeCholesky {
 public:
  double missing = 0;     ///< where factorise failed: at least so much more damping is needed
  JointVector direction;  ///< and along this, the last variable first,
  double curvature = 0;   ///< H + damping I is so curved

  /// False if a pivot is not clearly positive: then nothing can be solved. Of H the lower triangle
  /// is read.
  bool factorise(const Eigen::MatrixXd& hessian, double damping, const std::vector<char>& held);
  /// right_side becomes the solution; a held variable's entry stays what it is.
  void solve(JointVector& right_side) const;

 private:
  double squared_length_at(Eigen::Index row);

  JointRows rows;                   ///< L, the last variable first
  std::vector<Eigen::Index> first;  ///< of each row
  JointVector inverse_pivot;
};

}  // namespace morphe::solve
