#include "stages/segment/finger_motion.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::segment {
namespace {

constexpr double kMinApertureShare = 0.5;  ///< share of the tip's displacement
/// Window over which the change of the aperture is measured: half before, half after.
constexpr double kChangeWindow_s = 0.1;
/// Least change in this window, as a share of the least total change.
constexpr double kLocalChangeShare = 0.2;

std::size_t slowest(const HandSignals& signals, std::size_t first, std::size_t last) {
  const auto begin = signals.speed.begin();
  return std::min_element(begin + first, begin + last + 1) - begin;
}

/// The aperture of one recording and the thresholds for a change of it.
struct ApertureChanges {
  const std::vector<double>& opening;
  double min_change_m = 0, min_local_change_m = 0;
  std::size_t half = 1;  ///< half of kChangeWindow_s, in frames

  ApertureChanges(const HandSignals& signals, const SegmentOptions& options)
      : opening(signals.aperture) {
    const auto [least, most] = std::minmax_element(opening.begin(), opening.end());
    const double noise = kMinApertureNoiseRatio * signals.aperture_noise;
    min_change_m = std::max(noise, options.closing_share * (*most - *least));
    min_local_change_m = std::max(noise, kLocalChangeShare * min_change_m);
    half = std::max<std::size_t>(1, static_cast<std::size_t>(kChangeWindow_s / signals.step_s) / 2);
  }
  double local_change(std::size_t i) const {
    return opening[std::min(i + half, opening.size() - 1)] - opening[i - std::min(i, half)];
  }
  /// Returns the frame between `from` and `to` up to which the hand opens or closes as at `from`;
  /// `from` itself if that change is too small.
  std::size_t end_of_change(std::size_t from, std::size_t to) const {
    const double sign = std::copysign(1.0, local_change(from));
    std::size_t i = from;
    while (i != to && sign * local_change(i) > min_local_change_m) i = to > from ? i + 1 : i - 1;
    return std::abs(opening[i] - opening[from]) > min_change_m ? i : from;
  }
};

/// Returns the fastest frame from `from` (excluded) to `to` if its speed exceeds `least`, otherwise
/// `from`.
std::size_t fastest_frame(const HandSignals& signals, double least, std::size_t from,
                          std::size_t to) {
  std::size_t fastest = from;
  for (std::size_t i = from; i != to;) {
    i = to > from ? i + 1 : i - 1;
    if (fastest == from || signals.speed[i] > signals.speed[fastest]) fastest = i;
  }
  const bool rises = fastest + 1 < from || fastest > from + 1;
  return rises && signals.speed[fastest] > least ? fastest : from;
}

void extend_unit(const HandSignals& signals, const SegmentOptions& options,
                 const ApertureChanges& changes, std::size_t earliest, std::size_t latest,
                 MovementUnit& bout) {
  const double least = std::max(options.onset_share * signals.speed[bout.peak],
                                kMinPeakNoiseRatio * signals.speed_noise);
  const std::size_t begin = std::max(earliest, signals.frame(bout.begin_s));
  const std::size_t end = std::min(latest, signals.frame(bout.end_s));
  const std::size_t first =
      fastest_frame(signals, least, begin, changes.end_of_change(begin, earliest));
  const std::size_t last = fastest_frame(signals, least, end, changes.end_of_change(end, latest));
  if (first == begin && last == end) return;
  if (first != begin) {
    bout.first_peak = first;
    bout.first = slowest(signals, earliest, first);
  }
  if (last != end) {
    bout.last_peak = last;
    bout.last = slowest(signals, last, latest);
  }
  find_boundaries(signals, options, bout);
}

}  // namespace

bool is_finger_motion(const HandSignals& signals, const MovementUnit& bout) {
  if (signals.aperture.empty()) return false;
  const std::size_t begin = signals.frame(bout.begin_s), end = signals.frame(bout.end_s);
  const double tip = (bout.end_position - bout.start_position).norm();
  return (signals.wrist[end] - signals.wrist[begin]).norm() < kMinWristShare * tip &&
         std::abs(signals.aperture[end] - signals.aperture[begin]) > kMinApertureShare * tip;
}

void extend_by_finger_motion(const HandSignals& signals, const SegmentOptions& options,
                             std::vector<MovementUnit>& bouts) {
  if (signals.aperture.empty()) return;
  const ApertureChanges changes(signals, options);
  std::vector<MovementUnit> strong = bouts;
  std::erase_if(strong, [](const MovementUnit& bout) { return bout.weak; });
  for (std::size_t k = 0; k < strong.size(); ++k) {
    const std::size_t earliest = k == 0 ? 0 : slowest(signals, strong[k - 1].last, strong[k].first);
    const std::size_t latest = k + 1 == strong.size()
                                   ? signals.frames() - 1
                                   : slowest(signals, strong[k].last, strong[k + 1].first);
    extend_unit(signals, options, changes, earliest, latest, strong[k]);
  }
  std::size_t next = 0;
  for (MovementUnit& bout : bouts) {
    if (!bout.weak) bout = strong[next++];
  }
  std::erase_if(bouts, [&](const MovementUnit& bout) {
    return bout.weak && std::ranges::any_of(strong, [&](const MovementUnit& other) {
             return bout.first < other.last && other.first < bout.last;
           });
  });
}

}  // namespace morphe::segment
