#pragma once

#include <Eigen/Core>
#include <vector>

namespace morphe::solve {

/// A x = b for a symmetric positive definite A of n x n blocks whose blocks off its diagonal are
/// diagonal themselves, and zero more than kBandBlocks off: what frames in a row make that
/// differences of third order join. By the block Cholesky factor, 9 n³ operations a frame, row of
/// blocks by row of blocks, in a kernel that keeps 12 x 4 numbers in registers; solves of a size
/// after the first allocate nothing.
class BandCholesky {
 public:
  static constexpr Eigen::Index kBandBlocks = 3;
  using Own = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
  using Diagonal = Eigen::Map<Eigen::VectorXd, 0, Eigen::InnerStride<>>;

  void resize(std::size_t frames, Eigen::Index n);
  /// Block row `frame` of A's lower half, all zero: to be filled in before factorise() replaces it
  /// by the factor's.
  void clear(std::size_t frame);
  /// The block of `frame` with itself, of which the lower triangle counts.
  Own own(std::size_t frame);
  /// The diagonal of that with the frame one, two or three before.
  Diagonal between(std::size_t frame, Eigen::Index before);
  /// False if A is not positive definite. The block rows before `first` are still those of the last
  /// factorise(), and only the others were filled in since.
  bool factorise(std::size_t first = 0);
  /// b [frames * n] becomes x.
  void solve(Eigen::VectorXd& b);

 private:
  double* columns(std::size_t frame, Eigen::Index before) {
    return rows_.data() + (static_cast<Eigen::Index>(frame + 1) * (kBandBlocks + 1) - before - 1) *
                              padded_ * padded_;
  }
  bool factorise_block(std::size_t frame, Eigen::Index before, Eigen::Index reach);

  Eigen::Index n_ = 0, padded_ = 0;  ///< rows of a block, and to the next multiple of 4
  std::vector<double> rows_;         ///< [frames][4 padded][padded], column by column
  std::vector<double> inverse_, x_;  ///< [frames][padded] of the pivots; the solution
};

}  // namespace morphe::solve
