#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/math/statistics.hpp"
#include "core/motion/count_with_noun.hpp"
#include "stages/import/audit/checks.hpp"
#include "stages/import/audit/constants.hpp"
#include "stages/import/audit/point_streams.hpp"

namespace morphe::imports {
namespace {

/// The median length of a vector of three standard normal numbers, times the standard deviation of
/// the third difference of white noise over its own.
const double kMedianPerDeviation = 1.538 * std::sqrt(20.0);

/// Returns the standard deviation of white noise in each coordinate of a point, in its quiet
/// windows [m]; NaN if it is seen too little. Third differences remove the motion.
double noise_of(const PointStream& stream, std::size_t point, std::size_t window) {
  std::vector<double> windows, lengths;
  const Array2D<Vec3>& p = stream.position;
  for (std::size_t i = 3; i < stream.time.size(); ++i) {
    const Vec3 third = p(i, point) - p(i - 3, point) - 3 * (p(i - 1, point) - p(i - 2, point));
    if (is_known(third)) lengths.push_back(third.norm());
    if (i % window != 0) continue;
    if (2 * lengths.size() > window) windows.push_back(math::median(lengths));
    lengths.clear();
  }
  return math::quantile(std::move(windows), kQuietShare) / kMedianPerDeviation;
}

/// A point that trembles, and the noise that the reconstruction's low-pass leaves of it.
struct Trembling {
  std::size_t point = 0;
  double left_m = 0, limit_m = 0;
};

/// Returns the points that tremble more than usual, of estimated ones also those that tremble more
/// than markers do and much more than the others of their stream.
std::vector<Trembling> trembling_points(const PointStream& stream, double limit_m) {
  std::vector<Trembling> found, all;
  std::vector<double> levels;
  const double period_s = median_period(stream.time);
  const double duration_s = period_s * static_cast<double>(stream.time.size());
  if (!(duration_s > kJitterWindow_s) || period_s > kMaxJitterPeriod_s) return found;
  const auto window = static_cast<std::size_t>(std::ceil(kJitterWindow_s / period_s));
  const double left = std::sqrt(std::min(1.0, kFilterNoise * kFilter_hz * period_s));
  for (std::size_t k = 0; k < stream.names.size(); ++k) {
    if (stream.other_side[k]) continue;
    all.push_back({k, left * noise_of(stream, k, window), limit_m});
    if (std::isfinite(all.back().left_m)) levels.push_back(all.back().left_m);
  }
  const double relative_limit_m = kMaxJitterRatio * math::median(std::move(levels));
  for (Trembling& one : all) {
    one.limit_m = std::min(limit_m, std::max(kMaxMarkerJitter_m, relative_limit_m));
    if (one.left_m > one.limit_m) found.push_back(one);
  }
  return found;
}

}  // namespace

std::vector<Doubt> check_jitter(const Demonstration& recording, const AuditInput& /*input*/) {
  std::vector<Doubt> doubts;
  for (const PointStream& stream : point_streams(recording)) {
    if (stream.time.size() < 2) continue;
    const bool measured =
        stream.kind == PointStreamKind::markers || stream.kind == PointStreamKind::sensors;
    const double limit_m = measured ? kMaxMarkerJitter_m : kMaxEstimateJitter_m;
    const std::vector<Trembling> found = trembling_points(stream, limit_m);
    if (found.empty()) continue;
    const auto worst = std::ranges::max_element(found, {}, &Trembling::left_m);
    Doubt doubt;
    doubt.flag.code = FlagCode::jitter;
    doubt.flag.subject = stream.names[worst->point];
    doubt.flag.value = worst->left_m;
    doubt.flag.limit = worst->limit_m;
    doubt.flag.unit = "m";
    doubt.flag.text = fmt::format(
        "{} of {} tremble; {} most, by {:.1f} mm (standard deviation, at most {:.1f} mm is usual) "
        "after the low-pass",
        found.size(), count_with_noun(stream.names.size(), "point"), doubt.flag.subject,
        kMillimetresPerMetre * doubt.flag.value, kMillimetresPerMetre * worst->limit_m);
    doubts.push_back(std::move(doubt));
  }
  return doubts;
}

}  // namespace morphe::imports
