#pragma once

#include "core/motion/geometry.hpp"

namespace morphe::math {

/// A symmetric positive definite matrix with `band` diagonals below the main one: entry(i, d) is
/// A(i, i - d).
struct BandedMatrix {
  Eigen::Index size = 0, band = 0;
  Eigen::VectorXd values;  ///< [size * (band + 1)]

  BandedMatrix(Eigen::Index size_in, Eigen::Index band_in)
      : size(size_in), band(band_in), values(Eigen::VectorXd::Zero(size_in * (band_in + 1))) {}
  double& entry(Eigen::Index row, Eigen::Index below) { return values[row * (band + 1) + below]; }
  double entry(Eigen::Index row, Eigen::Index below) const {
    return values[row * (band + 1) + below];
  }
};

/// A = L L^T in place; false if A is not positive definite.
bool factor(BandedMatrix& matrix);
/// Solves L L^T x = b in place, after factor(); b [size] or a column for each right side.
void solve_factored(const BandedMatrix& factored, Eigen::Ref<Eigen::VectorXd> b);
void solve_factored(const BandedMatrix& factored, JointRows& b);

}  // namespace morphe::math
