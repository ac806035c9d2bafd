#include "core/solve/band_cholesky.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace morphe::solve {
namespace {

using Eigen::Index;

constexpr Index kSimdWidth = 4;
using SimdVector = double __attribute__((vector_size(kSimdWidth * sizeof(double))));

SimdVector load(const double* source) {
  SimdVector four;
  std::memcpy(&four, source, sizeof four);
  return four;
}
void store(const SimdVector& four, double* to) { std::memcpy(to, &four, sizeof four); }

/// Four columns of a block of the factor, `stride` apart.
struct Panel {
  const double* left;   ///< factor entries to the left of the target's rows
  const double* right;  ///< factor entries to the left of these columns' pivot rows
  Index depth;          ///< number of columns to the left
  Index stride;
};

/// Computes sum = target [4 kRows, 4] - left rightᵀ for rows from `row`, columns from `first` on.
template <int kRows>
void subtract_product(const Panel& panel, Index row, Index first, const double* target,
                      SimdVector (&sum)[kRows][kSimdWidth]) {
  for (Index c = 0; c < kSimdWidth; ++c)
    for (Index r = 0; r < kRows; ++r)
      sum[r][c] = load(target + c * panel.stride + row + r * kSimdWidth);
  const double* left = panel.left + first * panel.stride + row;
  const double* right = panel.right + first * panel.stride;
  for (Index k = first; k < panel.depth; ++k, left += panel.stride, right += panel.stride) {
    SimdVector rows[kRows];
    for (Index r = 0; r < kRows; ++r) rows[r] = load(left + r * kSimdWidth);
    for (Index c = 0; c < kSimdWidth; ++c)
      for (Index r = 0; r < kRows; ++r) sum[r][c] -= rows[r] * right[c];
  }
}

template <int kRows>
void store(const SimdVector (&sum)[kRows][kSimdWidth], Index row, Index stride, double* target) {
  for (Index c = 0; c < kSimdWidth; ++c)
    for (Index r = 0; r < kRows; ++r) store(sum[r][c], target + c * stride + row + r * kSimdWidth);
}

/// Solves rows of the panel below its pivots, or of another block: (target - left rightᵀ) L⁻ᵀ.
template <int kRows>
void solve_panel(const Panel& panel, const double* inverse, Index row, Index first,
                 double* target) {
  SimdVector sum[kRows][kSimdWidth];
  subtract_product(panel, row, first, target, sum);
  const double* pivots = panel.right + panel.depth * panel.stride;
  for (Index c = 0; c < kSimdWidth; ++c) {
    for (Index d = 0; d < c; ++d) {
      const double factor = pivots[d * panel.stride + c];
      for (Index r = 0; r < kRows; ++r) sum[r][c] -= factor * sum[r][d];
    }
    for (Index r = 0; r < kRows; ++r) sum[r][c] *= inverse[c];
  }
  store(sum, row, panel.stride, target);
}

/// Factorises the four rows with the panel's own pivots. Returns false if a pivot is not positive.
bool factor_pivots(const Panel& panel, Index row, Index first, double* target, double* inverse) {
  SimdVector sum[1][kSimdWidth];
  subtract_product(panel, row, first, target, sum);
  for (Index c = 0; c < kSimdWidth; ++c) {
    for (Index d = 0; d < c; ++d) sum[0][c] -= sum[0][d][c] * sum[0][d];
    if (!(sum[0][c][c] > 0)) return false;
    inverse[c] = 1 / std::sqrt(sum[0][c][c]);
    sum[0][c] *= inverse[c];
  }
  store(sum, row, panel.stride, target);
  return true;
}

}  // namespace

void BandCholesky::resize(Index frames, Index n) {
  n_ = n;
  padded_ = (n + kSimdWidth - 1) / kSimdWidth * kSimdWidth;
  rows_.resize(frames * (kBandBlocks + 1) * padded_ * padded_);
  inverse_.resize(frames * padded_);
  x_.resize(frames * padded_);
}

void BandCholesky::clear_row(Index frame) {
  std::fill_n(columns(frame, kBandBlocks), (kBandBlocks + 1) * padded_ * padded_, 0.0);
  double* own = columns(frame, 0);
  for (Index j = n_; j < padded_; ++j) own[j * padded_ + j] = 1;  // the identity beyond the matrix
}

BandCholesky::Own BandCholesky::diagonal_block(Index frame) {
  return {columns(frame, 0), n_, n_, Eigen::OuterStride<>(padded_)};
}

BandCholesky::Diagonal BandCholesky::off_diagonal(Index frame, Index before) {
  return {columns(frame, before), n_, Eigen::InnerStride<>(padded_ + 1)};
}

bool BandCholesky::factorise(Index first) {
  const Index frames = std::ssize(inverse_) / padded_;
  for (Index frame = first; frame < frames; ++frame) {
    const Index row_blocks = std::min(frame, kBandBlocks);
    for (Index before = row_blocks; before >= 0; --before)
      if (!factorise_block(frame, before, row_blocks)) return false;
  }
  return true;
}

/// Computes L_fe = (A_fe - sum over c < e of L_fc L_ecᵀ) L_ee⁻ᵀ for e = f - before, four columns at
/// a time; of the last block only the lower triangle. The first block of a row, a diagonal block
/// times a transposed factor, is zero below its diagonal; rows and columns of zeros are skipped
/// there. Returns false if a pivot is not positive.
bool BandCholesky::factorise_block(Index frame, Index before, Index row_blocks) {
  const std::size_t other = frame - before;
  const Index blocks = row_blocks - before;  // common to both rows and before this one
  double* target = columns(frame, before);
  double* inverse = inverse_.data() + other * padded_;
  for (Index j = 0; j < padded_; j += kSimdWidth) {
    const Panel panel{columns(frame, row_blocks), columns(other, blocks) + j, blocks * padded_ + j,
                      padded_};
    double* column = target + j * padded_;
    const auto first = [&](Index row) { return row_blocks > 0 ? row : 0; };
    Index row = 0;
    if (before == 0) {
      if (!factor_pivots(panel, j, first(j), column, inverse + j)) return false;
      row = j + kSimdWidth;
    }
    const Index end = before > 0 && blocks == 0 ? j + kSimdWidth : padded_;
    for (; row + 3 * kSimdWidth <= end; row += 3 * kSimdWidth)
      solve_panel<3>(panel, inverse + j, row, first(row), column);
    if (end - row == 2 * kSimdWidth) solve_panel<2>(panel, inverse + j, row, first(row), column);
    if (end - row == kSimdWidth) solve_panel<1>(panel, inverse + j, row, first(row), column);
  }
  return true;
}

void BandCholesky::solve(Eigen::VectorXd& b) {
  const Index frames = std::ssize(inverse_) / padded_;
  std::ranges::fill(x_, 0);
  for (Index f = 0; f < frames; ++f) std::copy_n(b.data() + f * n_, n_, x_.data() + f * padded_);
  for (Index f = 0; f < frames; ++f) {
    const Index width = std::min(f, kBandBlocks) * padded_;
    const double* column = columns(f, 0) - width * padded_;
    double* own = x_.data() + f * padded_;
    for (Index k = -width; k < 0; ++k, column += padded_)
      for (Index i = 0; i < padded_; ++i) own[i] -= own[k] * column[i];
    for (Index j = 0; j < n_; ++j, column += padded_) {
      own[j] *= inverse_[f * padded_ + j];
      for (Index i = j + 1; i < padded_; ++i) own[i] -= own[j] * column[i];
    }
  }
  for (Index f = frames - 1; f >= 0; --f) {
    const Index width = std::min(f, kBandBlocks) * padded_;
    double* own = x_.data() + f * padded_;
    const Eigen::Map<const Eigen::VectorXd> mine(own, n_);
    const double* column = columns(f, 0) + (n_ - 1) * padded_;
    for (Index j = n_ - 1; j >= 0; --j, column -= padded_) {
      const Index below = n_ - 1 - j;
      const Eigen::Map<const Eigen::VectorXd> under(column + j + 1, below);
      own[j] = (own[j] - under.dot(mine.tail(below))) * inverse_[f * padded_ + j];
    }
    for (Index k = -1; k >= -width; --k, column -= padded_)
      own[k] -= Eigen::Map<const Eigen::VectorXd>(column, n_).dot(mine);
  }
  for (Index f = 0; f < frames; ++f) std::copy_n(x_.data() + f * padded_, n_, b.data() + f * n_);
}

}  // namespace morphe::solve
