#include "pipeline/solve/band_cholesky.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

namespace morphe {

using Eigen::Index;

void BandCholesky::resize(std::size_t frames, Index n) {
  n_ = n;
  rows_.resize(frames);
  for (Eigen::MatrixXd& row : rows_) row.resize(n, (kBandBlocks + 1) * n);
}

bool BandCholesky::factorise() {
  const auto frames = static_cast<Index>(rows_.size());
  const auto columns_of = [&](Index frame, Index of) {  // where a block of row `of` begins
    return (kBandBlocks - (of - frame)) * n_;
  };
  for (Index f = 0; f < frames; ++f) {
    Eigen::MatrixXd& row = rows_[static_cast<std::size_t>(f)];
    const Index first = std::max<Index>(0, f - kBandBlocks);
    for (Index e = first; e < f; ++e) {
      // L_fe = (A_fe - sum over c < e of L_fc L_ecᵀ) L_ee⁻ᵀ
      const Eigen::MatrixXd& above = rows_[static_cast<std::size_t>(e)];
      auto block = row.middleCols(columns_of(e, f), n_);
      const Index width = (e - first) * n_;
      if (width > 0) {
        block.noalias() -= row.middleCols(columns_of(first, f), width) *
                           above.middleCols(columns_of(first, e), width).transpose();
      }
      above.rightCols(n_)
          .triangularView<Eigen::Lower>()
          .transpose()
          .solveInPlace<Eigen::OnTheRight>(block);
    }
    auto own = row.rightCols(n_);
    const Index width = (f - first) * n_;
    if (width > 0) {
      own.selfadjointView<Eigen::Lower>().rankUpdate(row.middleCols(columns_of(first, f), width),
                                                     -1);
    }
    Eigen::Ref<Eigen::MatrixXd> factor = own;
    if (Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>>(factor).info() != Eigen::Success) return false;
  }
  return true;
}

void BandCholesky::solve(Eigen::VectorXd& b) const {
  const auto frames = static_cast<Index>(rows_.size());
  for (Index f = 0; f < frames; ++f) {
    const Eigen::MatrixXd& row = rows_[static_cast<std::size_t>(f)];
    const Index width = std::min(f, kBandBlocks) * n_;
    auto own = b.segment(f * n_, n_);
    if (width > 0) {
      own.noalias() -=
          row.middleCols(kBandBlocks * n_ - width, width) * b.segment(f * n_ - width, width);
    }
    row.rightCols(n_).triangularView<Eigen::Lower>().solveInPlace(own);
  }
  for (Index f = frames - 1; f >= 0; --f) {
    const Eigen::MatrixXd& row = rows_[static_cast<std::size_t>(f)];
    const Index width = std::min(f, kBandBlocks) * n_;
    auto own = b.segment(f * n_, n_);
    row.rightCols(n_).triangularView<Eigen::Lower>().transpose().solveInPlace(own);
    if (width > 0) {
      b.segment(f * n_ - width, width).noalias() -=
          row.middleCols(kBandBlocks * n_ - width, width).transpose() * own;
    }
  }
}

}  // namespace morphe
