#pragma once

#include <Eigen/Core>
#include <vector>

namespace morphe {

/// A x = b for a symmetric positive definite A of n x n blocks that is zero more than kBandBlocks
/// blocks off its diagonal: what frames in a row make that differences of third order join. By the
/// block Cholesky factor, 12 n³ operations a frame; solves of a size after the first allocate
/// nothing.
class BandCholesky {
 public:
  static constexpr Eigen::Index kBandBlocks = 3;

  void resize(std::size_t frames, Eigen::Index n);
  /// Block row `frame` of A's lower half, [n, 4 n]: the blocks with frames frame - 3 … frame, those
  /// before the first frame unused; of the last block the lower triangle. To be filled in before
  /// each factorise(), which replaces it by the factor's.
  Eigen::MatrixXd& row(std::size_t frame) { return rows_[frame]; }
  Eigen::Ref<Eigen::MatrixXd> block(std::size_t frame, Eigen::Index before) {
    return rows_[frame].middleCols((kBandBlocks - before) * n_, n_);
  }
  /// False if A is not positive definite.
  bool factorise();
  /// b [frames * n] becomes x.
  void solve(Eigen::VectorXd& b) const;

 private:
  Eigen::Index n_ = 0;
  std::vector<Eigen::MatrixXd> rows_;
};

}  // namespace morphe
