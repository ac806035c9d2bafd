#include "stages/import/audit/body_jumps.hpp"

#include <algorithm>
#include <cmath>

#include "stages/import/audit/constants.hpp"

namespace morphe::imports {
namespace {

/// The jumps of all points at one row.
struct RowSums {
  int moving = 0;   ///< points that jump or are in motion
  int fast = 0;     ///< points that jump, or would if one row were lost
  int jumping = 0;  ///< points that jump and do not return
  int far = 0;      ///< points that jump farther than a person moves
  double size_m = 0;
  double residual_square = 0, usual_square = 0, product = 0;
};

/// Returns true if a point that jumps at a row is back on its course within the length of a spike,
/// or, backwards, was on it before.
bool is_spike(const StepTable& steps, std::size_t row, std::size_t point,
              std::ptrdiff_t direction) {
  double size_m = 0;
  Vec3 away = Vec3::Zero();
  for (std::ptrdiff_t n = 0; n <= static_cast<std::ptrdiff_t>(kMaxSpikeRows); ++n) {
    const std::ptrdiff_t i = static_cast<std::ptrdiff_t>(row) + direction * n;
    if (i < 0 || i >= static_cast<std::ptrdiff_t>(steps.residual.rows)) return false;
    if (is_known(steps.residual(i, point))) away += steps.residual(i, point);
    if (n > 0 && away.norm() < kReturnRatio * size_m) return true;
    size_m = std::max(size_m, away.norm());
  }
  return false;
}

bool jumps_and_stays(const StepTable& steps, std::size_t row, std::size_t point) {
  return steps.is_outlier(row, point) && !is_spike(steps, row, point, 1) &&
         !is_spike(steps, row, point, -1);
}

RowSums sums_at(const StepTable& steps, std::size_t row) {
  RowSums sums;
  for (std::size_t k = 0; k < steps.residual.cols; ++k) {
    const Vec3 &residual = steps.residual(row, k), &usual = steps.usual(row, k);
    if (!is_known(residual)) continue;
    const bool jumps = jumps_and_stays(steps, row, k);
    sums.jumping += jumps ? 1 : 0;
    sums.far += jumps && steps.is_far_outlier(row, k) ? 1 : 0;
    sums.moving += jumps || usual.norm() > kMinMotionStep_m ? 1 : 0;
    sums.fast += jumps || usual.norm() > kMinOutlier_m ? 1 : 0;
    if (jumps) sums.size_m = std::max(sums.size_m, residual.norm());
    sums.residual_square += residual.squaredNorm();
    sums.usual_square += usual.squaredNorm();
    sums.product += residual.dot(usual);
  }
  return sums;
}

}  // namespace

std::vector<BodyJump> body_jumps(const PointStream& stream, const StepTable& steps) {
  std::vector<BodyJump> found;
  if (steps.period_s <= 0) return found;
  for (std::size_t row = 1; row < stream.time.size(); ++row) {
    const RowSums sums = sums_at(steps, row);
    if (sums.jumping < kMinJumpingPoints) continue;
    const double rows_lost = sums.product / sums.usual_square;
    const bool along =
        rows_lost > 0 && rows_lost * sums.product > kAlongShare * sums.residual_square;
    const bool single = along && rows_lost < kMinRowsLost;
    if (sums.jumping < kJumpingShare * (single ? sums.fast : sums.moving)) continue;
    if (along ? rows_lost < kMinSingleRowLost : sums.far < kJumpingShare * sums.moving) continue;
    found.push_back({row, sums.size_m, along ? rows_lost : kUnknown});
  }
  const auto is_single = [](const BodyJump& jump) { return jump.rows_lost < kMinRowsLost; };
  if (std::ranges::count_if(found, is_single) < kMinSingleRows) std::erase_if(found, is_single);
  return found;
}

}  // namespace morphe::imports
