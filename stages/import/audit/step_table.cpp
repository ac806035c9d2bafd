#include "stages/import/audit/step_table.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/statistics.hpp"
#include "stages/import/audit/constants.hpp"

namespace morphe::imports {
namespace {

/// A step of a point from one seen sample to the next one.
struct SeenStep {
  std::size_t row = 0;
  double periods = 1;         ///< time between the two
  Eigen::Array4d per_period;  ///< [m] and an unused 0, which makes it one packet of the processor
};

std::vector<SeenStep> seen_steps(const PointStream& stream, double period_s, std::size_t point) {
  std::vector<SeenStep> steps;
  std::ptrdiff_t last = -1;
  for (std::size_t i = 0; i < stream.time.size(); ++i) {
    if (!is_known(stream.position(i, point))) continue;
    if (last >= 0) {
      const double periods = (stream.time[i] - stream.time[last]) / period_s;
      const Vec3 step = stream.position(i, point) - stream.position(last, point);
      if (periods > 0 && periods <= kMaxStepGap) {
        const Vec3 per_period = step / periods;
        steps.push_back({i, periods, {per_period.x(), per_period.y(), per_period.z(), 0}});
      }
    }
    last = static_cast<std::ptrdiff_t>(i);
  }
  return steps;
}

/// Returns the median of each coordinate of the steps around one. Orders the lower half of all
/// three at once, which is faster than three selections.
Vec3 usual_step(const std::vector<SeenStep>& steps, std::ptrdiff_t at) {
  const auto begin = std::max<std::ptrdiff_t>(0, at - kStepWindow);
  const auto end = std::min(std::ssize(steps), at + kStepWindow + 1);
  Eigen::Array4d values[2 * kStepWindow + 1];
  const std::ptrdiff_t count = end - begin, middle = count / 2;
  for (std::ptrdiff_t k = 0; k < count; ++k) values[k] = steps[begin + k].per_period;
  for (std::ptrdiff_t k = 0; k <= middle; ++k) {
    for (std::ptrdiff_t m = k + 1; m < count; ++m) {
      const Eigen::Array4d smaller = values[k].min(values[m]);
      values[m] = values[k].max(values[m]);
      values[k] = smaller;
    }
  }
  return values[middle].matrix().head<3>();
}

/// Returns the median residual in the rows around one, itself excluded.
double local_residual(const StepTable& steps, std::size_t row, std::size_t point) {
  std::vector<double> around;
  const auto at = static_cast<std::ptrdiff_t>(row);
  const auto end =
      std::min(static_cast<std::ptrdiff_t>(steps.residual.rows), at + kLocalWindow + 1);
  for (auto i = std::max<std::ptrdiff_t>(0, at - kLocalWindow); i < end; ++i) {
    const double length = steps.residual(i, point).norm();
    if (i != at && std::isfinite(length)) around.push_back(length);
  }
  return around.empty() ? 0 : math::median(std::move(around));
}

/// Returns true if the distance of two points hardly changes in these rows; sets its median.
bool keep_distance(const PointStream& stream, const std::vector<std::size_t>& rows, std::size_t a,
                   std::size_t b, double& distance_m) {
  std::vector<double> distances;
  for (const std::size_t i : rows) {
    const double distance = (stream.position(i, a) - stream.position(i, b)).norm();
    if (std::isfinite(distance)) distances.push_back(distance);
  }
  if (distances.size() < kMinJudgedRows) return false;
  distance_m = math::median(distances);
  if (distance_m > kMaxNeighbour_m) return false;
  const double spread = math::quantile(distances, 0.9) - math::quantile(distances, 0.1);
  return spread <= std::max(kRigidSpread_m, kRigidSpreadRatio * distance_m);
}

}  // namespace

bool StepTable::is_outlier(std::size_t row, std::size_t point) const {
  const double square = periods[row * residual.cols + point] * periods[row * residual.cols + point];
  const double length = residual(row, point).norm() / square;
  return length > std::max({kMinOutlier_m, kOutlierPerNoise * noise_m[point],
                            kOutlierPerLarge * large_m[point]}) &&
         length > kOutlierPerLocal * local_residual(*this, row, point);
}

bool StepTable::is_far_outlier(std::size_t row, std::size_t point) const {
  if (!is_outlier(row, point)) return false;
  const double square = periods[row * residual.cols + point] * periods[row * residual.cols + point];
  const double length = residual(row, point).norm() / square;
  return length > std::max({kMinFarOutlier_m, kFarAcceleration_m_s2 * period_s * period_s,
                            kFarPerLarge * large_m[point]});
}

StepTable step_table(const PointStream& stream) {
  StepTable table;
  const std::size_t rows = stream.position.rows, points = stream.position.cols;
  if (rows < kMinJudgedRows) return table;
  table.period_s = median_period(stream.time);
  table.residual = table.usual = Array2D<Vec3>(rows, points, unknown_point());
  table.periods.assign(rows * points, 1);
  for (std::size_t k = 0; k < points; ++k) {
    const std::vector<SeenStep> steps = seen_steps(stream, table.period_s, k);
    std::vector<double> lengths;
    for (std::ptrdiff_t at = 0; at < std::ssize(steps); ++at) {
      const Vec3 usual = usual_step(steps, at);
      const Vec3 residual = steps[at].periods * (steps[at].per_period.matrix().head<3>() - usual);
      table.usual(steps[at].row, k) = usual;
      table.residual(steps[at].row, k) = residual;
      table.periods[steps[at].row * points + k] = steps[at].periods;
      lengths.push_back(residual.norm());
    }
    table.noise_m.push_back(lengths.empty() ? 0 : math::median(lengths));
    table.large_m.push_back(lengths.empty() ? 0 : math::quantile(lengths, kLargeShare));
  }
  return table;
}

const StepTable& StepTables::of(const PointStream& stream) {
  auto table = tables_.find(stream.kind);
  if (table == tables_.end()) table = tables_.emplace(stream.kind, step_table(stream)).first;
  return table->second;
}

std::vector<std::size_t> rigid_neighbours(const PointStream& stream, std::size_t point) {
  std::vector<std::size_t> rows;
  const std::size_t stride = std::max<std::size_t>(1, stream.position.rows / kNeighbourSamples);
  for (std::size_t i = 0; i < stream.position.rows; i += stride) rows.push_back(i);
  std::vector<std::pair<double, std::size_t>> near;
  for (std::size_t k = 0; k < stream.position.cols; ++k) {
    double distance_m = 0;
    if (k != point && keep_distance(stream, rows, point, k, distance_m))
      near.emplace_back(distance_m, k);
  }
  std::ranges::sort(near);
  std::vector<std::size_t> neighbours;
  for (std::size_t m = 0; m < std::min(kMaxNeighbours, near.size()); ++m)
    neighbours.push_back(near[m].second);
  return neighbours;
}

std::optional<Vec3> own_residual(const StepTable& steps, const std::vector<std::size_t>& neighbours,
                                 std::size_t row, std::size_t point) {
  std::vector<Vec3> shared;
  for (const std::size_t k : neighbours) {
    if (is_known(steps.residual(row, k))) shared.push_back(steps.residual(row, k));
  }
  if (shared.size() < 2) return std::nullopt;
  return steps.residual(row, point) - math::median_point(shared);
}

}  // namespace morphe::imports
