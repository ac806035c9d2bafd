#include "stages/segment/bouts.hpp"

#include <algorithm>
#include <cmath>

namespace morphe {
namespace {

using Speeds = std::vector<double>;

constexpr double kNearlyRest = 1.25;  ///< a dip to this multiple of the rest speed is a rest too,
constexpr double kNearlyRestRatio = 0.6;  ///< … if it is also below this share of the smaller peak
constexpr double kLeastBout = 0.08;       ///< [s]
constexpr double kFitLow = 0.03, kFitHigh = 0.3;

std::size_t fastest(const Speeds& speed, std::size_t first, std::size_t last) {
  const auto begin = speed.begin();
  return static_cast<std::size_t>(std::max_element(begin + static_cast<std::ptrdiff_t>(first),
                                                   begin + static_cast<std::ptrdiff_t>(last) + 1) -
                                  begin);
}

double slowest_speed(const Speeds& speed, std::size_t first, std::size_t last) {
  return *std::min_element(speed.begin() + static_cast<std::ptrdiff_t>(first),
                           speed.begin() + static_cast<std::ptrdiff_t>(last) + 1);
}

/// Cuts [first, last] at its relatively deepest dip, then both sides; the dip ends the left bout
/// and begins the right one.
void split_at_dips(const Speeds& speed, std::size_t first, std::size_t last, double rest,
                   double dip_share, std::vector<Bout>& out) {
  std::size_t best = first;
  double best_ratio = 1;
  if (last > first + 1) {
    Speeds right(last - first + 1);
    right.back() = speed[last];
    for (std::size_t i = last; i-- > first;) {
      right[i - first] = std::max(speed[i], right[i - first + 1]);
    }
    double left = speed[first];
    for (std::size_t i = first + 1; i < last; ++i) {
      left = std::max(left, speed[i]);
      if (speed[i] >= speed[i - 1] || speed[i] > speed[i + 1]) continue;
      const double ratio = speed[i] / std::min(left, right[i - first]);
      const bool deep =
          ratio < dip_share || (speed[i] <= kNearlyRest * rest && ratio < kNearlyRestRatio);
      if (deep && ratio < best_ratio) {
        best = i;
        best_ratio = ratio;
      }
    }
  }
  if (best == first) {
    Bout bout;
    bout.first = first;
    bout.last = last;
    bout.peak = fastest(speed, first, last);
    out.push_back(bout);
    return;
  }
  split_at_dips(speed, first, best, rest, dip_share, out);
  split_at_dips(speed, best, last, rest, dip_share, out);
}

/// First peak that matters: at least a quarter of the fastest, followed by a fall of a fifth.
std::size_t first_peak(const Speeds& speed, std::size_t first, std::size_t last) {
  const double least = 0.25 * speed[fastest(speed, first, last)];
  std::size_t peak = first;
  for (std::size_t i = first; i <= last; ++i) {
    if (speed[i] > speed[peak]) peak = i;
    if (speed[peak] >= least && speed[i] < 0.8 * speed[peak]) break;
  }
  return peak;
}

void place_ends(const HandSignals& signals, const SegmentOptions& options, double top, Bout& bout) {
  const Speeds& speed = signals.speed;
  const double rest = options.stop_share * top;
  const bool from_rest = bout.first > 0 && speed[bout.first - 1] <= rest;
  const bool to_rest = bout.last + 1 < speed.size() && speed[bout.last + 1] <= rest;
  bout.cut = bout.first == 0 && speed[0] > rest;

  // A rise that starts from rest may reach back into it; one that starts at a dip may not.
  std::size_t back = bout.first;
  while (from_rest && back > 0 && speed[back - 1] < speed[back]) --back;
  double onset = static_cast<double>(bout.first);
  if (!bout.cut) {
    const double fit = fitted_onset(speed, back, bout.last, options.onset_share * top);
    const double earliest =
        from_rest ? std::max(0.0, static_cast<double>(bout.first) - 0.3 / signals.step_s) : onset;
    if (std::isfinite(fit)) onset = std::clamp(fit, earliest, static_cast<double>(bout.peak));
  }
  double stop = static_cast<double>(bout.last);
  if (to_rest) {
    const double fall = speed[bout.last] - speed[bout.last + 1];
    if (fall > 0) stop += std::clamp((speed[bout.last] - rest) / fall, 0.0, 1.0);
  }
  bout.begin_s = signals.time(onset);
  bout.end_s = signals.time(stop);
}

void judge_ends(const Speeds& speed, double dip_share, std::vector<Bout>& bouts) {
  for (std::size_t k = 0; k < bouts.size(); ++k) {
    const double peak = speed[bouts[k].peak];
    if (k == 0) {
      const double slowest = slowest_speed(speed, 0, bouts[k].first);
      bouts[k].begin_confidence = bouts[k].cut ? 0 : boundary_confidence(slowest, peak, dip_share);
    }
    if (k + 1 == bouts.size()) {
      const double slowest = slowest_speed(speed, bouts[k].last, speed.size() - 1);
      const bool ends_in_motion = bouts[k].last + 1 == speed.size();
      bouts[k].end_confidence = ends_in_motion ? 0 : boundary_confidence(slowest, peak, dip_share);
      continue;
    }
    const double smaller = std::min(peak, speed[bouts[k + 1].peak]);
    const double slowest = slowest_speed(speed, bouts[k].last, bouts[k + 1].first);
    bouts[k].end_confidence = boundary_confidence(slowest, smaller, dip_share);
    bouts[k + 1].begin_confidence = bouts[k].end_confidence;
    bouts[k + 1].begin_s = std::max(bouts[k + 1].begin_s, bouts[k].end_s);
  }
}

}  // namespace

double boundary_confidence(double slowest, double smaller_peak, double dip_share) {
  return std::clamp(1 - slowest / (dip_share * smaller_peak), 0.0, 1.0);
}

double fitted_onset(const Speeds& speed, std::size_t first, std::size_t last, double level) {
  const std::size_t top = first_peak(speed, first, last);
  const double peak = speed[top];
  const auto share_of_time = [peak](double v) {
    return (1 - std::sqrt(1 - std::sqrt(std::clamp(v / peak, 0.0, 1.0)))) / 2;
  };
  std::size_t i = top;
  while (i > first && speed[i] > kFitHigh * peak) --i;
  double count = 0, mean_x = 0, mean_y = 0, xx = 0, xy = 0;
  for (; speed[i] > kFitLow * peak; --i) {
    const double x = share_of_time(speed[i]), y = static_cast<double>(i);
    count += 1;
    const double dx = x - mean_x, dy = y - mean_y;
    mean_x += dx / count;
    mean_y += dy / count;
    xx += dx * (x - mean_x);
    xy += dx * (y - mean_y);
    if (i == first || speed[i - 1] >= speed[i]) break;
  }
  if (count < 3 || !(xx > 0) || !(xy > 0)) return kNotSeen;
  return mean_y + xy / xx * (share_of_time(level) - mean_x);
}

std::vector<Bout> find_bouts(const HandSignals& signals, const SegmentOptions& options) {
  const Speeds& speed = signals.speed;
  if (speed.empty()) return {};
  const double top = *std::max_element(speed.begin(), speed.end());
  if (top < options.least_peak) return {};
  const double rest = options.stop_share * top;

  std::vector<Bout> pieces;
  for (std::size_t i = 0; i < speed.size(); ++i) {
    if (speed[i] <= rest) continue;
    const std::size_t first = i;
    while (i + 1 < speed.size() && speed[i + 1] > rest) ++i;
    split_at_dips(speed, first, i, rest, options.dip_share, pieces);
  }
  std::vector<Bout> bouts;
  for (Bout& piece : pieces) {
    const double length_s = static_cast<double>(piece.last - piece.first) * signals.step_s;
    if (speed[piece.peak] < options.weak_share * top || length_s < kLeastBout) continue;
    place_ends(signals, options, top, piece);
    bouts.push_back(piece);
  }
  judge_ends(speed, options.dip_share, bouts);
  return bouts;
}

}  // namespace morphe
