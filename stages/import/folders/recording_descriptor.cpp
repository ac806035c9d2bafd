#include "stages/import/folders/recording_descriptor.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace morphe::imports {
namespace {

constexpr double kMaxStaticDeviation_m = 0.020, kDeviationTolerance_m = 0.0005;
/// At least three, since a single marker may have been mislabelled.
constexpr std::size_t kLargestDeviationCount = 3;
constexpr double kMinSeenShare = 0.1;

/// Returns the rms deviation [m], NaN if the point was hardly seen.
double rms_deviation(const Array2D<Vec3>& position, std::size_t column) {
  Vec3 sum = Vec3::Zero();
  double squares = 0, count = 0;
  const Vec3* origin = nullptr;  // close to the points, so that squares do not cancel
  for (std::size_t row = 0; row < position.rows; ++row) {
    const Vec3& point = position(row, column);
    if (!is_known(point)) continue;
    if (origin == nullptr) origin = &point;
    const Vec3 from_origin = point - *origin;
    sum += from_origin;
    squares += from_origin.squaredNorm();
    ++count;
  }
  if (count == 0 || count < kMinSeenShare * static_cast<double>(position.rows)) return kUnknown;
  return std::sqrt(std::max(0.0, squares / count - (sum / count).squaredNorm()));
}

void add_points(const std::vector<std::string>& names, const Array2D<Vec3>& position,
                RecordingDescriptor& sketch) {
  std::vector<std::size_t> order(names.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t k) { return names[k]; });
  for (const std::size_t k : order) {
    const double wander = rms_deviation(position, k);
    if (std::isnan(wander)) continue;
    sketch.points.push_back(names[k]);
    sketch.rms_deviation_m.push_back(wander);
  }
  sketch.samples = position.rows;
}

}  // namespace

RecordingDescriptor recording_descriptor(const Demonstration& demonstration) {
  RecordingDescriptor sketch;
  sketch.subject = demonstration.subject;
  const Streams& streams = demonstration.streams;
  if (streams.markers) {
    sketch.has_markers = true;
    add_points(streams.markers->names, streams.markers->position, sketch);
  } else if (streams.sensors) {
    add_points(streams.sensors->names, streams.sensors->position, sketch);
  } else if (streams.skeleton) {
    add_points(streams.skeleton->names, streams.skeleton->position, sketch);
  }
  return sketch;
}

bool is_stationary(const RecordingDescriptor& sketch) {
  std::vector<double> widest = sketch.rms_deviation_m;
  if (widest.empty()) return false;
  const std::size_t count = std::min(kLargestDeviationCount, widest.size());
  std::ranges::nth_element(widest, widest.begin() + (count - 1), std::greater<>());
  return widest[count - 1] < kMaxStaticDeviation_m;
}

bool same_recording(const RecordingDescriptor& a, const RecordingDescriptor& b) {
  if (a.samples != b.samples || a.points.empty()) return false;
  std::size_t shared = 0;
  for (std::size_t k = 0; k < a.points.size(); ++k) {
    const auto there = std::ranges::lower_bound(b.points, a.points[k]);
    if (there == b.points.end() || *there != a.points[k]) continue;
    ++shared;
    const auto at = static_cast<std::size_t>(there - b.points.begin());
    if (std::abs(a.rms_deviation_m[k] - b.rms_deviation_m[at]) > kDeviationTolerance_m)
      return false;
  }
  return 2 * shared > a.points.size();
}

}  // namespace morphe::imports
