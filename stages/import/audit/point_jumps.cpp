#include "stages/import/audit/point_jumps.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "stages/import/audit/constants.hpp"

namespace morphe::imports {
namespace {

/// The jumps of a stream's points.
struct Jumps {
  const PointStream& stream;
  const StepTable& steps;
  std::vector<std::vector<std::size_t>> rows = {};  ///< [K] of each point, ascending
};

bool is_jump(const Jumps& jumps, const std::vector<std::size_t>& neighbours, std::size_t row,
             std::size_t point) {
  const double length_m = jumps.steps.residual(row, point).norm();
  const auto own = own_residual(jumps.steps, neighbours, row, point);
  if (own && own->norm() > std::max(kMinOutlier_m, kOwnShare * length_m)) return true;
  const std::vector<double>& time = jumps.stream.time;
  const double step_s = std::max(jumps.steps.period_s, row > 0 ? time[row] - time[row - 1] : 0);
  return length_m > kMinOutlier_m + kArmAcceleration_m_s2 * step_s * step_s;
}

/// Returns the place where a point would be without its residual.
Vec3 usual_place(const Jumps& jumps, std::size_t row, std::size_t point) {
  return jumps.stream.position(row, point) - jumps.steps.residual(row, point);
}

/// Returns true if some point is at the usual place of `point`, and `point` at that of another one.
bool is_exchange(const Jumps& jumps, std::size_t row, std::size_t point) {
  const Array2D<Vec3>& position = jumps.stream.position;
  const double tolerance_m =
      std::clamp(kExchangeToleranceRatio * jumps.steps.residual(row, point).norm(),
                 kMinExchangeTolerance_m, kMaxExchangeTolerance_m);
  bool takes = false, is_taken = false;
  for (std::size_t k = 0; k < position.cols; ++k) {
    if (k == point || !(jumps.steps.residual(row, k).norm() > tolerance_m)) continue;
    takes |= (position(row, point) - usual_place(jumps, row, k)).norm() < tolerance_m;
    is_taken |= (position(row, k) - usual_place(jumps, row, point)).norm() < tolerance_m;
  }
  return takes && is_taken;
}

Jumps find_jumps(const PointStream& stream, const StepTable& steps,
                 const std::vector<std::size_t>& body_jump_rows) {
  Jumps jumps{stream, steps};
  jumps.rows.resize(stream.names.size());
  for (std::size_t k = 0; k < stream.names.size(); ++k) {
    std::optional<std::vector<std::size_t>> neighbours;
    for (std::size_t i = 0; i < stream.time.size() && !stream.other_side[k]; ++i) {
      if (!steps.is_outlier(i, k) || std::ranges::binary_search(body_jump_rows, i)) continue;
      if (!neighbours) neighbours = rigid_neighbours(stream, k);
      if (is_jump(jumps, *neighbours, i, k) && !is_exchange(jumps, i, k))
        jumps.rows[k].push_back(i);
    }
  }
  return jumps;
}

/// Returns the first row of the samples before `row` without a long gap between them.
std::size_t run_begin(const Jumps& jumps, std::size_t row, std::size_t point) {
  std::size_t begin = row;
  for (std::size_t i = row; i-- > 0;) {
    if (!is_known(jumps.stream.position(i, point))) continue;
    begin = i;
    if (!is_known(jumps.steps.residual(i, point))) break;
  }
  return begin;
}

/// Follows a point from a jump until it is back on its course, or until it is not seen any more;
/// `returns` is false if it does neither within the length of a spike.
Excursion follow(const Jumps& jumps, std::size_t row, std::size_t point) {
  const std::vector<double>& time = jumps.stream.time;
  const std::vector<std::size_t>& rows = jumps.rows[point];
  Excursion excursion{point, row, row + 1, jumps.steps.residual(row, point).norm(), true};
  Vec3 away = jumps.steps.residual(row, point);
  bool ends = true;
  for (std::size_t i = row + 1; i < time.size(); ++i) {
    if (!is_known(jumps.stream.position(i, point))) continue;
    const Vec3& residual = jumps.steps.residual(i, point);
    if (!is_known(residual)) break;
    away += residual;
    const bool back = away.norm() <= kReturnRatio * excursion.size_m;
    if (back && std::ranges::binary_search(rows, i)) return excursion;
    ends = i - row < kMaxSpikeRows && time[i] - time[row] <= kMaxSpike_s;
    if (!ends) break;
    excursion.end = i + 1;
    excursion.size_m = std::max(excursion.size_m, away.norm());
  }
  excursion.returns = ends && jumps.steps.is_far_outlier(row, point);
  return excursion;
}

}  // namespace

std::vector<Excursion> excursions(const PointStream& stream, const StepTable& steps,
                                  const std::vector<std::size_t>& body_jump_rows) {
  std::vector<Excursion> found;
  if (steps.period_s <= 0) return found;
  const Jumps jumps = find_jumps(stream, steps, body_jump_rows);
  for (std::size_t k = 0; k < jumps.rows.size(); ++k) {
    std::size_t judged_until = 0;
    for (const std::size_t row : jumps.rows[k]) {
      if (row <= judged_until && judged_until > 0) continue;
      Excursion excursion = follow(jumps, row, k);
      if (!excursion.returns) {
        if (!steps.is_far_outlier(row, k)) continue;
        const std::size_t begin = run_begin(jumps, row, k);
        if (row - begin < kMaxSpikeRows) excursion = {k, begin, row, excursion.size_m, true};
      }
      if (excursion.returns) judged_until = std::max(row, excursion.end);
      found.push_back(excursion);
    }
  }
  return found;
}

}  // namespace morphe::imports
