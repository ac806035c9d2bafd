#pragma once

#include "core/motion/geometry.hpp"

namespace morphe::math {

/// A symmetric positive definite matrix A with `bandwidth` diagonals below the main one.
struct BandedMatrix {
  Eigen::Index size = 0, bandwidth = 0;
  Eigen::VectorXd values;  ///< [size * (bandwidth + 1)]

  /// Makes a zero matrix.
  BandedMatrix(Eigen::Index size_in, Eigen::Index band_in)
      : size(size_in), bandwidth(band_in), values(Eigen::VectorXd::Zero(size_in * (band_in + 1))) {}
  /// Returns A(row, row - below).
  double& entry(Eigen::Index row, Eigen::Index below) {
    return values[row * (bandwidth + 1) + below];
  }
  /// Returns A(row, row - below).
  double entry(Eigen::Index row, Eigen::Index below) const {
    return values[row * (bandwidth + 1) + below];
  }
};

/// Factorises A = L L^T in place; returns false if A is not positive definite.
bool factor(BandedMatrix& matrix);
/// Solves L L^T x = b in place, after factor(); b [size].
void solve_factored(const BandedMatrix& factored, Eigen::Ref<Eigen::VectorXd> b);
/// Solves L L^T x = b in place, after factor(), for every column of b [size, columns].
void solve_factored(const BandedMatrix& factored, JointRows& b);

}  // namespace morphe::math
