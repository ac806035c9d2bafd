#include "stages/import/folders/recording_descriptor.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace morphe::imports {
namespace {

constexpr double kMaxStaticDeviation_m = 0.020, kDeviationTolerance_m = 0.0005;
/// Rank of the tested deviation. Larger ones are ignored, since a marker may have been mislabelled.
constexpr std::ptrdiff_t kTestedDeviationRank = 3;
constexpr double kMinSeenShare = 0.1;  ///< of all frames

/// Returns the rms deviation of a column's points from their mean [m]; NaN if hardly any was seen.
double rms_deviation(const Array2D<Vec3>& position, std::size_t column) {
  Vec3 sum = Vec3::Zero();
  double square_sum = 0, count = 0;
  const Vec3* origin = nullptr;  // near the points, so that the difference below loses no digits
  for (std::size_t row = 0; row < position.rows; ++row) {
    const Vec3& point = position(row, column);
    if (!is_known(point)) continue;
    if (!origin) origin = &point;
    const Vec3 from_origin = point - *origin;
    sum += from_origin;
    square_sum += from_origin.squaredNorm();
    ++count;
  }
  if (count == 0 || count < kMinSeenShare * static_cast<double>(position.rows)) return kUnknown;
  return std::sqrt(std::max(0.0, square_sum / count - (sum / count).squaredNorm()));
}

void add_points(const std::vector<std::string>& names, const Array2D<Vec3>& position,
                RecordingDescriptor& descriptor) {
  std::vector<int> order(names.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](int k) { return names[k]; });
  for (const int k : order) {
    const double deviation_m = rms_deviation(position, k);
    if (std::isnan(deviation_m)) continue;
    descriptor.points.push_back(names[k]);
    descriptor.rms_deviation_m.push_back(deviation_m);
  }
  descriptor.frame_count = position.rows;
}

}  // namespace

RecordingDescriptor recording_descriptor(const Demonstration& demonstration) {
  RecordingDescriptor descriptor;
  descriptor.subject = demonstration.subject;
  const Streams& streams = demonstration.streams;
  if (streams.markers) {
    descriptor.has_markers = true;
    add_points(streams.markers->names, streams.markers->position, descriptor);
  } else if (streams.sensors) {
    add_points(streams.sensors->names, streams.sensors->position, descriptor);
  } else if (streams.skeleton) {
    add_points(streams.skeleton->names, streams.skeleton->position, descriptor);
  }
  return descriptor;
}

bool is_stationary(const RecordingDescriptor& descriptor) {
  std::vector<double> deviations_m = descriptor.rms_deviation_m;
  if (deviations_m.empty()) return false;
  const auto tested = std::min(kTestedDeviationRank, std::ssize(deviations_m)) - 1;
  std::ranges::nth_element(deviations_m, deviations_m.begin() + tested, std::greater<>());
  return deviations_m[tested] < kMaxStaticDeviation_m;
}

bool same_recording(const RecordingDescriptor& a, const RecordingDescriptor& b) {
  if (a.frame_count != b.frame_count || a.points.empty()) return false;
  int shared = 0;
  for (int k = 0; k < std::ssize(a.points); ++k) {
    const auto point = std::ranges::lower_bound(b.points, a.points[k]);
    if (point == b.points.end() || *point != a.points[k]) continue;
    ++shared;
    const double deviation_m = b.rms_deviation_m[point - b.points.begin()];
    if (std::abs(a.rms_deviation_m[k] - deviation_m) > kDeviationTolerance_m) return false;
  }
  return 2 * shared > std::ssize(a.points);
}

}  // namespace morphe::imports
