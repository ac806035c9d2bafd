#include "pipeline/solve/band_cholesky.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace morphe::solve {
namespace {

using Eigen::Index;

constexpr Index kWidth = 4;
using Four = double __attribute__((vector_size(kWidth * sizeof(double))));

Four load(const double* from) {
  Four four;
  std::memcpy(&four, from, sizeof four);
  return four;
}
void store(const Four& four, double* to) { std::memcpy(to, &four, sizeof four); }

/// target [4 kRows, 4] -= left [4 kRows, depth] * right [4, depth]ᵀ; all have columns `stride`
/// apart.
template <int kRows>
void subtract_product(const double* left, const double* right, Index depth, Index stride,
                      double* target) {
  Four sum[kRows][kWidth];
  for (Index c = 0; c < kWidth; ++c) {
    for (Index r = 0; r < kRows; ++r) sum[r][c] = load(target + c * stride + r * kWidth);
  }
  for (Index k = 0; k < depth; ++k, left += stride, right += stride) {
    Four rows[kRows];
    for (Index r = 0; r < kRows; ++r) rows[r] = load(left + r * kWidth);
    for (Index c = 0; c < kWidth; ++c) {
      for (Index r = 0; r < kRows; ++r) sum[r][c] -= rows[r] * right[c];
    }
  }
  for (Index c = 0; c < kWidth; ++c) {
    for (Index r = 0; r < kRows; ++r) store(sum[r][c], target + c * stride + r * kWidth);
  }
}

/// The same for any multiple of 4 rows.
void subtract_product(Index rows, const double* left, const double* right, Index depth,
                      Index stride, double* target) {
  Index r = 0;
  for (; r + 12 <= rows; r += 12) {
    subtract_product<3>(left + r, right, depth, stride, target + r);
  }
  if (rows - r == 8) subtract_product<2>(left + r, right, depth, stride, target + r);
  if (rows - r == 4) subtract_product<1>(left + r, right, depth, stride, target + r);
}

}  // namespace

void BandCholesky::resize(std::size_t frames, Index n) {
  n_ = n;
  padded_ = (n + kWidth - 1) / kWidth * kWidth;
  const auto padded = static_cast<std::size_t>(padded_);
  rows_.resize(frames * (kBandBlocks + 1) * padded * padded);
  inverse_.resize(frames * padded);
  x_.resize(frames * padded);
}

void BandCholesky::clear(std::size_t frame) {
  std::fill_n(columns(frame, kBandBlocks), (kBandBlocks + 1) * padded_ * padded_, 0.0);
  double* own = columns(frame, 0);
  for (Index j = n_; j < padded_; ++j) own[j * padded_ + j] = 1;  // beyond the matrix: the identity
}

BandCholesky::Block BandCholesky::block(std::size_t frame, Index before) {
  return {columns(frame, before), n_, n_, Eigen::OuterStride<>(padded_)};
}

bool BandCholesky::factorise(std::size_t first) {
  const auto frames = inverse_.size() / static_cast<std::size_t>(padded_);
  for (std::size_t frame = first; frame < frames; ++frame) {
    const Index reach = std::min(static_cast<Index>(frame), kBandBlocks);
    for (Index before = reach; before >= 0; --before) {
      if (!factorise_block(frame, before, reach)) return false;
    }
  }
  return true;
}

/// L_fe = (A_fe - sum over c < e of L_fc L_ecᵀ) L_ee⁻ᵀ for e = f - before, four columns at a time;
/// of the last block only what is on the diagonal or below. False if a pivot is not positive.
bool BandCholesky::factorise_block(std::size_t frame, Index before, Index reach) {
  const std::size_t other = frame - static_cast<std::size_t>(before);
  const Index blocks = reach - before;  // that both rows have before this one
  const double* left = columns(frame, reach);
  const double* right = columns(other, blocks);
  double* target = columns(frame, before);
  double* inverse = inverse_.data() + static_cast<Index>(other) * padded_;
  for (Index j = 0; j < padded_; j += kWidth) {
    const Index top = before > 0 ? 0 : j;
    const Index depth = blocks * padded_ + j;
    subtract_product(padded_ - top, left + top, right + j, depth, padded_,
                     target + j * padded_ + top);
    const double* pivots = right + depth * padded_;  // columns j … j + 3 of L_ee
    for (Index c = j; c < j + kWidth; ++c) {
      double* column = target + c * padded_;
      for (Index d = j; d < c; ++d) {
        const double factor = pivots[(d - j) * padded_ + c];
        const double* known = target + d * padded_;
        for (Index i = top; i < padded_; ++i) column[i] -= factor * known[i];
      }
      if (before == 0) {
        if (!(column[c] > 0)) return false;
        inverse[c] = 1 / std::sqrt(column[c]);
      }
      for (Index i = top; i < padded_; ++i) column[i] *= inverse[c];
    }
  }
  return true;
}

void BandCholesky::solve(Eigen::VectorXd& b) {
  const auto frames = static_cast<Index>(inverse_.size()) / padded_;
  std::ranges::fill(x_, 0);
  for (Index f = 0; f < frames; ++f) {
    std::copy_n(b.data() + f * n_, n_, x_.data() + f * padded_);
  }
  for (Index f = 0; f < frames; ++f) {
    const Index reach = std::min(f, kBandBlocks) * padded_;
    const double* column = columns(static_cast<std::size_t>(f), 0) - reach * padded_;
    double* own = x_.data() + f * padded_;
    for (Index k = -reach; k < 0; ++k, column += padded_) {
      for (Index i = 0; i < padded_; ++i) own[i] -= own[k] * column[i];
    }
    for (Index j = 0; j < n_; ++j, column += padded_) {
      own[j] *= inverse_[static_cast<std::size_t>(f * padded_ + j)];
      for (Index i = j + 1; i < padded_; ++i) own[i] -= own[j] * column[i];
    }
  }
  for (Index f = frames - 1; f >= 0; --f) {
    const Index reach = std::min(f, kBandBlocks) * padded_;
    double* own = x_.data() + f * padded_;
    const Eigen::Map<const Eigen::VectorXd> mine(own, n_);
    const double* column = columns(static_cast<std::size_t>(f), 0) + (n_ - 1) * padded_;
    for (Index j = n_ - 1; j >= 0; --j, column -= padded_) {
      const Index below = n_ - 1 - j;
      const Eigen::Map<const Eigen::VectorXd> under(column + j + 1, below);
      own[j] = (own[j] - under.dot(mine.tail(below))) *
               inverse_[static_cast<std::size_t>(f * padded_ + j)];
    }
    for (Index k = -1; k >= -reach; --k, column -= padded_) {
      own[k] -= Eigen::Map<const Eigen::VectorXd>(column, n_).dot(mine);
    }
  }
  for (Index f = 0; f < frames; ++f) {
    std::copy_n(x_.data() + f * padded_, n_, b.data() + f * n_);
  }
}

}  // namespace morphe::solve
