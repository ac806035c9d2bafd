#include "stages/segment/fingers.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::segment {
namespace {

constexpr double kWithFingers = 0.5;  ///< share of the tip's way
constexpr double kWithin_s = 0.1;   ///< without a pause: it changes from half before to half behind
constexpr double kOnTheMove = 0.2;  ///< … by this share of what is asked of the whole

std::size_t slowest(const HandSignals& signals, std::size_t first, std::size_t last) {
  const auto begin = signals.speed.begin();
  return static_cast<std::size_t>(std::min_element(begin + static_cast<std::ptrdiff_t>(first),
                                                   begin + static_cast<std::ptrdiff_t>(last) + 1) -
                                  begin);
}

/// The opening of one recording, and what counts as a change of it.
struct Changes {
  const std::vector<double>& opening;
  double asked = 0, on_the_move = 0;
  std::size_t half = 1;  ///< of kWithin_s, in frames

  Changes(const HandSignals& signals, const SegmentOptions& options) : opening(signals.opening) {
    const auto [least, most] = std::minmax_element(opening.begin(), opening.end());
    const double noise = kOpeningAboveNoise * signals.opening_noise;
    asked = std::max(noise, options.closing_share * (*most - *least));
    on_the_move = std::max(noise, kOnTheMove * asked);
    half = std::max<std::size_t>(1, static_cast<std::size_t>(kWithin_s / signals.step_s) / 2);
  }
  double around(std::size_t i) const {
    return opening[std::min(i + half, opening.size() - 1)] - opening[i - std::min(i, half)];
  }
  /// The frame on the way from `from` to `to` up to which the hand goes on as it does at `from`;
  /// `from` if that does not amount to anything.
  std::size_t go_on(std::size_t from, std::size_t to) const {
    const double sign = std::copysign(1.0, around(from));
    std::size_t i = from;
    while (i != to && sign * around(i) > on_the_move) i = to > from ? i + 1 : i - 1;
    return std::abs(opening[i] - opening[from]) > asked ? i : from;
  }
};

/// The fastest frame from `from` (excluded) to `to` if it is fast enough to be under way, else
/// `from`.
std::size_t under_way(const HandSignals& signals, double least, std::size_t from, std::size_t to) {
  std::size_t fastest = from;
  for (std::size_t i = from; i != to;) {
    i = to > from ? i + 1 : i - 1;
    if (fastest == from || signals.speed[i] > signals.speed[fastest]) fastest = i;
  }
  const bool rises = fastest + 1 < from || fastest > from + 1;
  return rises && signals.speed[fastest] > least ? fastest : from;
}

void lengthen(const HandSignals& signals, const SegmentOptions& options, const Changes& changes,
              std::size_t earliest, std::size_t latest, Bout& bout) {
  const double least =
      std::max(options.onset_share * signals.speed[bout.peak], kNoisePeak * signals.speed_noise);
  const std::size_t begin = std::max(earliest, signals.frame(bout.begin_s));
  const std::size_t end = std::min(latest, signals.frame(bout.end_s));
  const std::size_t first = under_way(signals, least, begin, changes.go_on(begin, earliest));
  const std::size_t last = under_way(signals, least, end, changes.go_on(end, latest));
  if (first == begin && last == end) return;
  if (first != begin) {
    bout.first_part = first;
    bout.first = slowest(signals, earliest, first);
  }
  if (last != end) {
    bout.last_part = last;
    bout.last = slowest(signals, last, latest);
  }
  find_ends(signals, options, bout);
}

}  // namespace

bool only_fingers(const HandSignals& signals, const Bout& bout) {
  if (signals.opening.empty()) return false;
  const std::size_t begin = signals.frame(bout.begin_s), end = signals.frame(bout.end_s);
  const double tip = (bout.to - bout.from).norm();
  return (signals.wrist[end] - signals.wrist[begin]).norm() < kWithWrist * tip &&
         std::abs(signals.opening[end] - signals.opening[begin]) > kWithFingers * tip;
}

void take_in_fingers(const HandSignals& signals, const SegmentOptions& options,
                     std::vector<Bout>& bouts) {
  if (signals.opening.empty()) return;
  const Changes changes(signals, options);
  std::vector<Bout> strong = bouts;
  std::erase_if(strong, [](const Bout& bout) { return bout.weak; });
  for (std::size_t k = 0; k < strong.size(); ++k) {
    const std::size_t earliest = k == 0 ? 0 : slowest(signals, strong[k - 1].last, strong[k].first);
    const std::size_t latest = k + 1 == strong.size()
                                   ? signals.frames() - 1
                                   : slowest(signals, strong[k].last, strong[k + 1].first);
    lengthen(signals, options, changes, earliest, latest, strong[k]);
  }
  std::size_t next = 0;
  for (Bout& bout : bouts) {
    if (!bout.weak) bout = strong[next++];
  }
  std::erase_if(bouts, [&](const Bout& bout) {
    return bout.weak && std::ranges::any_of(strong, [&](const Bout& other) {
             return bout.first < other.last && other.first < bout.last;
           });
  });
}

}  // namespace morphe::segment
