#include "stages/import/audit/body_jumps.hpp"

#include <algorithm>
#include <cmath>

#include "stages/import/audit/constants.hpp"

namespace morphe::imports {
namespace {

/// The jumps of all points at one row.
struct RowSums {
  int moving = 0;   ///< points that jump or are in motion
  int jumping = 0;  ///< points that jump
  int far = 0;      ///< points that jump farther than a person moves
  double size_m = 0;
  double residual_square = 0, usual_square = 0, product = 0;
};

RowSums sums_at(const StepTable& steps, std::size_t row) {
  RowSums sums;
  for (std::size_t k = 0; k < steps.residual.cols; ++k) {
    const Vec3 &residual = steps.residual(row, k), &usual = steps.usual(row, k);
    if (!is_known(residual)) continue;
    const bool jumps = steps.is_outlier(row, k);
    sums.jumping += jumps ? 1 : 0;
    sums.far += jumps && steps.is_far_outlier(row, k) ? 1 : 0;
    sums.moving += jumps || usual.norm() > kMinMotionStep_m ? 1 : 0;
    if (jumps) sums.size_m = std::max(sums.size_m, residual.norm());
    sums.residual_square += residual.squaredNorm();
    sums.usual_square += usual.squaredNorm();
    sums.product += residual.dot(usual);
  }
  return sums;
}

/// Returns true if the jumping points are back on their course within the length of a spike.
bool is_spike(const StepTable& steps, std::size_t row, std::ptrdiff_t direction) {
  double size_square = 0;
  std::vector<Vec3> away(steps.residual.cols, Vec3::Zero());
  for (std::ptrdiff_t n = 0; n <= static_cast<std::ptrdiff_t>(kMaxSpikeRows); ++n) {
    const std::ptrdiff_t i = static_cast<std::ptrdiff_t>(row) + direction * n;
    if (i < 0 || i >= static_cast<std::ptrdiff_t>(steps.residual.rows)) return false;
    double square = 0;
    for (std::size_t k = 0; k < away.size(); ++k) {
      if (is_known(steps.residual(i, k))) away[k] += steps.residual(i, k);
      square += away[k].squaredNorm();
    }
    if (n > 0 && square < kReturnRatio * kReturnRatio * size_square) return true;
    size_square = std::max(size_square, square);
  }
  return false;
}

}  // namespace

std::vector<BodyJump> body_jumps(const PointStream& stream, const StepTable& steps) {
  std::vector<BodyJump> found;
  if (steps.period_s <= 0) return found;
  for (std::size_t row = 1; row < stream.time.size(); ++row) {
    const RowSums sums = sums_at(steps, row);
    if (sums.jumping < kMinJumpingPoints || sums.jumping < kJumpingShare * sums.moving) continue;
    const double rows_lost = sums.product / sums.usual_square;
    const bool along =
        rows_lost > 0 && rows_lost * sums.product > kAlongShare * sums.residual_square;
    if (along ? rows_lost < kMinRowsLost : sums.far < kJumpingShare * sums.moving) continue;
    if (is_spike(steps, row, 1) || is_spike(steps, row, -1)) continue;
    found.push_back({row, sums.size_m, along ? rows_lost : kUnknown});
  }
  return found;
}

}  // namespace morphe::imports
