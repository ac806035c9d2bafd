#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::solve {

/// Factorises H + damping I = sum over p of s_p s_pᵀ, in which s_p has no entries after p; rows and
/// columns of held variables are excluded. It eliminates from the last variable to the first, so
/// that there is no fill-in for a tree whose parents come first (a robot: arm, then fingers), and
/// rows without an entry at a pivot cost no operations. H can be any symmetric positive definite
/// matrix; a full one costs n³/3. No memory is allocated after the first call.
class EnvelopeCholesky {
 public:
  /// Lower bound of the additional damping that is needed if factorise() failed.
  double missing_damping = 0;
  JointVector negative_curvature_direction;  ///< direction of negative curvature in this case
  double curvature = 0;                      ///< curvature of H + damping I along it

  /// Factorises (reads H's upper triangle); if a pivot is not positive, returns false: no solve().
  bool factorise(const Eigen::MatrixXd& hessian, double damping, const std::vector<char>& held);
  /// Replaces right_side by the solution, after factorise(); entries of held variables stay.
  void solve(JointVector& right_side) const;

 private:
  double find_direction_of(Eigen::Index pivot);
  Eigen::Map<const JointVector> before(Eigen::Index pivot, Eigen::Index from = 0) const;

  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows;  ///< s_p, padded
  JointVector inverse_pivot;
};

}  // namespace morphe::solve
