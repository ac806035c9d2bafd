#include "core/math/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace morphe::math {
namespace {

double value_at_rank(std::vector<double>& values, std::ptrdiff_t rank) {
  std::ranges::nth_element(values, values.begin() + rank);
  return values[rank];
}

}  // namespace

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return kUnknown;
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
  return value_at_rank(values, std::min(values.size(), std::max<std::size_t>(rank, 1)) - 1);
}

double lower_quantile(std::vector<double> values, double share) {
  if (values.empty()) return kUnknown;
  return value_at_rank(values,
                       static_cast<std::size_t>(share * static_cast<double>(values.size() - 1)));
}

double median(std::vector<double> values) {
  return values.empty() ? kUnknown : value_at_rank(values, values.size() / 2);
}

double midpoint_median(std::vector<double> values) {
  if (values.empty()) return kUnknown;
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

Vec3 median_point(const std::vector<Vec3>& points) {
  std::vector<double> coordinates[3];
  for (const Vec3& point : points) {
    if (!is_known(point)) continue;
    for (int k = 0; k < 3; ++k) coordinates[k].push_back(point[k]);
  }
  Vec3 middle;
  for (int k = 0; k < 3; ++k) middle[k] = median(std::move(coordinates[k]));
  return middle;
}

double median_distance(const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
  std::vector<double> distances;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double distance = (to[i] - from[i]).norm();
    if (std::isfinite(distance)) distances.push_back(distance);
  }
  return median(std::move(distances));
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  std::size_t count = 0;
  for (const double value : values) {
    if (std::isnan(value)) continue;
    sum += value;
    ++count;
  }
  return count == 0 ? kUnknown : sum / static_cast<double>(count);
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() < 2) return kUnknown;
  // Element by element: the order of Eigen's sums depends on the alignment of the data.
  const double mean_a = mean(a), mean_b = mean(b);
  double ab = 0, aa = 0, bb = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    ab += (a[k] - mean_a) * (b[k] - mean_b);
    aa += (a[k] - mean_a) * (a[k] - mean_a);
    bb += (b[k] - mean_b) * (b[k] - mean_b);
  }
  return ab / std::sqrt(aa * bb);
}

}  // namespace morphe::math
