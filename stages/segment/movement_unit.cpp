#include "stages/segment/movement_unit.hpp"

#include <algorithm>
#include <cmath>

#include "stages/segment/constants.hpp"
#include "stages/segment/speed_crossing.hpp"

namespace morphe::segment {
namespace {

/// Returns the rise of the speed within kReboundWindow_s outside a boundary, up to frame `rest`,
/// relative to the level of the boundary. Near 1, the motion outside might as well belong to the
/// unit.
double rebound(const HandSignals& signals, double boundary_s, int rest, double level) {
  const int window = signals.frames_in(kReboundWindow_s);
  int i = signals.frame(boundary_s);
  double slowest = signals.speed[i], rise = 0;  // rise: above the slowest so far
  for (int k = 0; i != rest && k < window; ++k) {
    i += rest > i ? 1 : -1;
    slowest = std::min(slowest, signals.speed[i]);
    rise = std::max(rise, signals.speed[i] - slowest);
  }
  return rise / level;
}

}  // namespace

int slowest_frame(const HandSignals& signals, int first, int last) {
  int slowest = first;
  for (int i = first + 1; i <= last; ++i) {
    if (signals.speed[i] < signals.speed[slowest]) slowest = i;
  }
  return slowest;
}

int fastest_frame(const HandSignals& signals, int first, int last) {
  int fastest = first;
  for (int i = first + 1; i <= last; ++i) {
    if (signals.speed[fastest] < signals.speed[i]) fastest = i;
  }
  return fastest;
}

void find_boundaries(const HandSignals& signals, const SegmentOptions& options,
                     MovementUnit& unit) {
  const double level = options.onset_share * signals.speed[unit.peak];
  const double min_part = options.weak_unit_share * signals.speed[unit.peak];
  const SpeedCrossing begin =
      find_speed_crossing(signals, unit.first, unit.first_peak, level, min_part);
  const SpeedCrossing end =
      find_speed_crossing(signals, unit.last, unit.last_peak, level, min_part);
  unit.begin_s = signals.time(begin.frame);
  unit.end_s = signals.time(end.frame);
  unit.begin_confidence = 1 / (1 + std::pow(begin.time_sd_s / kHalfConfidenceSpread_s, 2));
  unit.end_confidence = 1 / (1 + std::pow(end.time_sd_s / kHalfConfidenceSpread_s, 2));
  const double before = rebound(signals, unit.begin_s, unit.first, level);
  const double after = rebound(signals, unit.end_s, unit.last, level);
  unit.begin_confidence /= 1 + before * before;
  unit.end_confidence /= 1 + after * after;
  unit.begin_truncated = begin.frame <= 0;
  unit.end_truncated = end.frame >= signals.frames() - 1;
  const int first = signals.frame(unit.begin_s), last = signals.frame(unit.end_s);
  unit.start_position = signals.position[first];
  unit.end_position = signals.position[last];
  unit.extent = 0;
  for (int i = first; i <= last; ++i)
    unit.extent = std::max(unit.extent, (signals.position[i] - unit.start_position).norm());
}

void merge_unit(const HandSignals& signals, const SegmentOptions& options,
                const MovementUnit& other, MovementUnit& unit) {
  if (other.first < unit.first) unit.first_peak = other.first_peak;
  if (other.last > unit.last) unit.last_peak = other.last_peak;
  unit.first = std::min(unit.first, other.first);
  unit.last = std::max(unit.last, other.last);
  if (signals.speed[other.peak] > signals.speed[unit.peak]) unit.peak = other.peak;
  find_boundaries(signals, options, unit);
}

}  // namespace morphe::segment
