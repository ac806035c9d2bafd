#include "stages/import/folders/recording_descriptor.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

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

using Deviations = std::map<std::string, double>;  // rms [m] by name

template <class Stream>
void add_points(const std::optional<Stream>& stream, Deviations& deviations,
                RecordingDescriptor& descriptor) {
  if (!stream) return;
  for (std::size_t k = 0; k < stream->names.size(); ++k) {
    const double deviation_m = rms_deviation(stream->position, k);
    if (!std::isnan(deviation_m)) deviations.emplace(stream->names[k], deviation_m);
  }
  descriptor.frame_count = std::max(descriptor.frame_count, stream->position.rows);
}

}  // namespace

RecordingDescriptor recording_descriptor(const Demonstration& demonstration) {
  RecordingDescriptor descriptor;
  descriptor.subject = demonstration.subject;
  const Streams& streams = demonstration.streams;
  descriptor.has_markers = streams.markers.has_value();
  Deviations deviations;
  add_points(streams.markers, deviations, descriptor);
  add_points(streams.skeleton, deviations, descriptor);
  if (deviations.empty()) add_points(streams.sensors, deviations, descriptor);
  for (const auto& [name, deviation_m] : deviations) {
    descriptor.points.push_back(name);
    descriptor.rms_deviation_m.push_back(deviation_m);
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
