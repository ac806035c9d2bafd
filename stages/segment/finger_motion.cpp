#include "stages/segment/finger_motion.hpp"

#include <algorithm>
#include <cmath>

#include "stages/segment/constants.hpp"

namespace morphe::segment {
namespace {

/// The aperture of one recording and the thresholds for a change of it.
struct ApertureChanges {
  const std::vector<double>& aperture;
  const int last;
  double min_change_m = 0, min_local_change_m = 0;
  int half_window = 1;  ///< half of kChangeWindow_s, in frames

  ApertureChanges(const HandSignals& signals, const SegmentOptions& options)
      : aperture(signals.aperture), last(signals.frames() - 1) {
    const auto [narrowest, widest] = std::minmax_element(aperture.begin(), aperture.end());
    const double noise = kMinApertureNoiseRatio * signals.aperture_noise;
    min_change_m = std::max(noise, options.closing_share * (*widest - *narrowest));
    min_local_change_m = std::max(noise, kLocalChangeShare * min_change_m);
    half_window = std::max(1, signals.frames_in(kChangeWindow_s) / 2);
  }
  double local_change(int i) const {
    return aperture[std::min(i + half_window, last)] - aperture[std::max(i - half_window, 0)];
  }
  /// Returns the frame on the way from `from` to `to` up to which the hand keeps opening, or
  /// closing, as at `from`; `from` itself if the aperture changes too little on this way.
  int end_of_change(int from, int to) const {
    const double sign = std::copysign(1.0, local_change(from));
    int i = from;
    while (i != to && sign * local_change(i) > min_local_change_m) i += to > from ? 1 : -1;
    return std::abs(aperture[i] - aperture[from]) > min_change_m ? i : from;
  }
};

/// Returns the fastest frame from `from` (excluded) to `to`, if it is not beside `from` and faster
/// than `min_speed`; otherwise `from`.
int fastest_beyond(const HandSignals& signals, double min_speed, int from, int to) {
  int fastest = from;  // while it is `from`, there is no frame yet
  for (int i = from; i != to;) {
    i += to > from ? 1 : -1;
    if (fastest == from || signals.speed[i] > signals.speed[fastest]) fastest = i;
  }
  return std::abs(fastest - from) > 1 && signals.speed[fastest] > min_speed ? fastest : from;
}

/// Extends a unit at both ends, within the frames earliest … latest.
void extend_unit(const HandSignals& signals, const SegmentOptions& options,
                 const ApertureChanges& changes, int earliest, int latest, MovementUnit& unit) {
  const double limit = std::max(options.onset_share * signals.speed[unit.peak],
                                kMinPeakNoiseRatio * signals.speed_noise);
  const int begin = std::max(earliest, signals.frame(unit.begin_s));
  const int end = std::min(latest, signals.frame(unit.end_s));
  const int first = fastest_beyond(signals, limit, begin, changes.end_of_change(begin, earliest));
  const int last = fastest_beyond(signals, limit, end, changes.end_of_change(end, latest));
  if (first == begin && last == end) return;
  if (first != begin) {
    unit.first_peak = first;
    unit.first = slowest_frame(signals, earliest, first);
  }
  if (last != end) {
    unit.last_peak = last;
    unit.last = slowest_frame(signals, last, latest);
  }
  find_boundaries(signals, options, unit);
}

}  // namespace

bool is_finger_motion(const HandSignals& signals, const MovementUnit& unit) {
  if (signals.aperture.empty()) return false;
  const int begin = signals.frame(unit.begin_s), end = signals.frame(unit.end_s);
  const double tip = unit.displacement().norm();
  return (signals.wrist[end] - signals.wrist[begin]).norm() < kMinWristShare * tip &&
         std::abs(signals.aperture[end] - signals.aperture[begin]) > kMinApertureShare * tip;
}

void extend_by_finger_motion(const HandSignals& signals, const SegmentOptions& options,
                             std::vector<MovementUnit>& units) {
  if (signals.aperture.empty()) return;
  const ApertureChanges changes(signals, options);
  std::vector<MovementUnit> strong = units;
  std::erase_if(strong, [](const MovementUnit& unit) { return unit.weak; });
  for (int k = 0; k < std::ssize(strong); ++k) {
    const int earliest = k == 0 ? 0 : slowest_frame(signals, strong[k - 1].last, strong[k].first);
    const int latest = k + 1 == std::ssize(strong)
                           ? signals.frames() - 1
                           : slowest_frame(signals, strong[k].last, strong[k + 1].first);
    extend_unit(signals, options, changes, earliest, latest, strong[k]);
  }
  auto extended = strong.begin();
  for (MovementUnit& unit : units) {
    if (!unit.weak) unit = *extended++;
  }
  std::erase_if(units, [&](const MovementUnit& unit) {
    return unit.weak && std::ranges::any_of(strong, [&](const MovementUnit& other) {
             return unit.first < other.last && other.first < unit.last;
           });
  });
}

}  // namespace morphe::segment
