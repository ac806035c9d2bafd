#pragma once

#include <Eigen/Core>
#include <vector>

namespace morphe::solve {

/// Solves A x = b for a symmetric positive definite A of n x n blocks, of which those off the
/// diagonal are diagonal matrices, and zero if more than kBandBlocks off it. Such is the A of
/// consecutive frames that are coupled by differences up to third order. The block Cholesky
/// factorisation takes 9 n³ operations per frame, one row of blocks after the other, in a kernel
/// that keeps 12 x 4 numbers in registers. It allocates no memory after the first solve of a size.
class BandCholesky {
 public:
  static constexpr Eigen::Index kBandBlocks = 3;
  using Own = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
  using Diagonal = Eigen::Map<Eigen::VectorXd, 0, Eigen::InnerStride<>>;

  /// Sets the number of frames and of variables per frame.
  void resize(Eigen::Index frames, Eigen::Index n);
  /// Zeroes block row `frame` of A's lower half, which factorise() replaces by the factor's.
  void clear_row(Eigen::Index frame);
  /// Returns the diagonal block of `frame`, of which the lower triangle is used.
  Own diagonal_block(Eigen::Index frame);
  /// Returns the diagonal of the block of `frame` with the frame one, two or three before.
  Diagonal off_diagonal(Eigen::Index frame, Eigen::Index before);
  /// Factorises A; returns false if it is not positive definite. The block rows before `first` keep
  /// the last factorisation, and only the others need to be filled in again.
  bool factorise(Eigen::Index first = 0);
  /// Replaces b [frames * n] by x; A must be factorised.
  void solve(Eigen::VectorXd& b);

 private:
  double* columns(Eigen::Index frame, Eigen::Index before) {
    return rows_.data() + ((frame + 1) * (kBandBlocks + 1) - before - 1) * padded_ * padded_;
  }
  bool factorise_block(Eigen::Index frame, Eigen::Index before, Eigen::Index row_blocks);

  Eigen::Index n_ = 0, padded_ = 0;  ///< rows of a block, and padded to a multiple of 4
  std::vector<double> rows_;         ///< [frames][4 padded][padded], in column-major order
  std::vector<double> inverse_, x_;  ///< [frames][padded]: inverse pivots; the solution
};

}  // namespace morphe::solve
