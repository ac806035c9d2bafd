#include "stages/segment/movement_units.hpp"

#include <algorithm>
#include <cmath>

#include "stages/segment/finger_motion.hpp"
#include "stages/segment/speed_crossing.hpp"

namespace morphe::segment {
namespace {

using Speeds = std::vector<double>;

constexpr double kSeparatingDipShare = 0.15;  ///< ratio of dip to peak that always separates
constexpr double kMinUnitDuration_s = 0.08;
constexpr double kSplitHalfWindow_s = 0.15;
/// Standard deviation of a boundary's time at which its confidence is halved.
constexpr double kHalfConfidenceSpread_s = 0.04;
constexpr double kReboundWindow_s = 0.3;
constexpr std::size_t kNeighbours = 2;

/// An interval with one or more peaks between two slow points.
struct SpeedInterval {
  std::size_t first = 0, last = 0, peak = 0;
};

std::size_t extreme_frame(const Speeds& speed, std::size_t first, std::size_t last, bool fastest) {
  const auto begin = speed.begin() + first;
  const auto end = speed.begin() + last + 1;
  const auto at = fastest ? std::max_element(begin, end) : std::min_element(begin, end);
  return at - speed.begin();
}

/// Returns the speed with the noise added everywhere, so that ratios of speeds at rest are not
/// significant.
double noise_biased_speed(const HandSignals& signals, std::size_t i) {
  return signals.speed[i] + signals.speed_noise + 1e-6;
}

/// Cuts at every dip below dip_share of the peaks on both sides, in one pass.
std::vector<SpeedInterval> cut_at_dips(const HandSignals& signals, double dip_share) {
  std::vector<std::size_t> bounds = {0};
  std::size_t low = 0, high = 0;
  bool rising = false, falling = false;
  for (std::size_t i = 1; i < signals.frames(); ++i) {
    const double v = noise_biased_speed(signals, i);
    if (v > noise_biased_speed(signals, high)) high = i;
    if (v < noise_biased_speed(signals, low)) low = i;
    if (!falling && v < dip_share * noise_biased_speed(signals, high)) {
      falling = true;
      rising = false;
      low = i;
    } else if (!rising && noise_biased_speed(signals, low) < dip_share * v) {
      rising = true;
      falling = false;
      if (low > 0) bounds.push_back(low);
      high = i;
    }
  }
  bounds.push_back(falling ? low : signals.frames() - 1);
  std::vector<SpeedInterval> pieces;
  for (std::size_t k = 1; k < bounds.size(); ++k) {
    if (bounds[k] <= bounds[k - 1]) continue;
    pieces.push_back(
        {bounds[k - 1], bounds[k], extreme_frame(signals.speed, bounds[k - 1], bounds[k], true)});
  }
  return pieces;
}

/// Returns the dip between two intervals relative to the allowed one. Above 1, the dip is too
/// shallow to separate them.
double dip_ratio(const HandSignals& signals, const SpeedInterval& a, const SpeedInterval& b,
                 double dip_share) {
  const auto way = [&](const SpeedInterval& piece) -> Vec3 {
    return (signals.position[piece.last] - signals.position[piece.first]).normalized();
  };
  const double allowed = std::clamp(dip_share * (1 - way(a).dot(way(b))),
                                    std::min(kSeparatingDipShare, dip_share), dip_share);
  const double smaller =
      std::min(noise_biased_speed(signals, a.peak), noise_biased_speed(signals, b.peak));
  return noise_biased_speed(signals, a.last) / smaller / allowed;
}

/// Joins intervals over shallow dips, the shallowest of each neighbourhood first.
void join_over_shallow_dips(const HandSignals& signals, double dip_share,
                            std::vector<SpeedInterval>& pieces) {
  for (bool changed = true; changed && pieces.size() > 1;) {
    changed = false;
    std::vector<double> shallow(pieces.size() + 1, 0.0);  // ratio of the dip before each interval
    for (std::size_t k = 1; k < pieces.size(); ++k) {
      shallow[k] = dip_ratio(signals, pieces[k - 1], pieces[k], dip_share);
    }
    std::vector<SpeedInterval> joined = {pieces[0]};
    bool just_joined = false;
    for (std::size_t k = 1; k < pieces.size(); ++k) {
      const bool join = !just_joined && shallow[k] > 1 && shallow[k] >= shallow[k - 1] &&
                        shallow[k] >= shallow[k + 1];
      just_joined = join;
      if (!join) {
        joined.push_back(pieces[k]);
        continue;
      }
      SpeedInterval& left = joined.back();
      left.last = pieces[k].last;
      if (signals.speed[pieces[k].peak] > signals.speed[left.peak]) left.peak = pieces[k].peak;
      changed = true;
    }
    pieces = std::move(joined);
  }
}

void split_at(const HandSignals& signals, double time_s, std::vector<SpeedInterval>& pieces) {
  const std::size_t first = signals.frame(time_s - kSplitHalfWindow_s);
  const std::size_t last = signals.frame(time_s + kSplitHalfWindow_s);
  const std::size_t slowest = extreme_frame(signals.speed, first, last, false);
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const SpeedInterval piece = pieces[k];
    if (slowest <= piece.first || slowest >= piece.last) continue;
    const SpeedInterval left{piece.first, slowest,
                             extreme_frame(signals.speed, piece.first, slowest, true)};
    const SpeedInterval right{slowest, piece.last,
                              extreme_frame(signals.speed, slowest, piece.last, true)};
    const double smaller = std::min(signals.speed[left.peak], signals.speed[right.peak]);
    // Already separated by a rest.
    if (signals.speed[slowest] < kSeparatingDipShare * smaller) return;
    if (left.peak == slowest || right.peak == slowest) return;
    pieces[k] = left;
    pieces.insert(pieces.begin() + k + 1, right);
    return;
  }
}

void mark_weak(const HandSignals& signals, const SegmentOptions& options,
               std::vector<MovementUnit>& bouts) {
  for (std::size_t k = 0; k < bouts.size(); ++k) {
    double farthest = 0;
    const std::size_t last = std::min(bouts.size() - 1, k + kNeighbours);
    for (std::size_t m = k - std::min(k, kNeighbours); m <= last; ++m) {
      farthest = std::max(farthest, bouts[m].extent);
    }
    bouts[k].weak = bouts[k].extent < options.weak_bout_share * farthest ||
                    signals.speed[bouts[k].peak] < options.min_peak_speed ||
                    is_finger_motion(signals, bouts[k]);
  }
}

/// Returns the score for merging the weak unit `other` into `bout`: the dip between them over the
/// level at which `bout` ends, if that or the peak of `other` is high enough; otherwise 0.
double merge_score(const HandSignals& signals, const SegmentOptions& options,
                   const MovementUnit& bout, const MovementUnit& other) {
  const bool after = other.peak > bout.peak;
  const std::size_t slowest = after ? extreme_frame(signals.speed, bout.peak, other.peak, false)
                                    : extreme_frame(signals.speed, other.peak, bout.peak, false);
  const double peak = signals.speed[bout.peak], level = options.onset_share * peak;
  const double dip = signals.speed[slowest] / level;
  const std::size_t edge = signals.frame(after ? bout.end_s : bout.begin_s);
  std::size_t near = other.peak;
  while (near != edge && signals.speed[near] >= level) near = after ? near - 1 : near + 1;
  const double gap_s =
      std::abs(signals.time(static_cast<double>(near)) - (after ? bout.end_s : bout.begin_s));
  const bool follows =
      gap_s <= kMaxMergeGap_s && signals.speed[other.peak] >= options.weak_bout_share * peak;
  return dip >= 1 || follows ? dip + 1e-9 : 0;
}

std::vector<MovementUnit> merge_weak_units(const HandSignals& signals,
                                           const SegmentOptions& options,
                                           const std::vector<MovementUnit>& bouts) {
  std::vector<MovementUnit> result;
  for (std::size_t k = 0; k < bouts.size(); ++k) {
    if (bouts[k].weak) {
      const bool left = !result.empty() && !result.back().weak;
      const bool right = k + 1 < bouts.size() && !bouts[k + 1].weak;
      const double to_left = left ? merge_score(signals, options, result.back(), bouts[k]) : 0;
      const double to_right = right ? merge_score(signals, options, bouts[k + 1], bouts[k]) : 0;
      if (to_left > 0 && to_left >= to_right) {
        merge_unit(signals, options, bouts[k], result.back());
        continue;
      }
      if (to_right > 0) {
        result.push_back(bouts[k + 1]);
        merge_unit(signals, options, bouts[k], result.back());
        ++k;
        continue;
      }
    }
    result.push_back(bouts[k]);
  }
  return result;
}

void measure_dips(const Speeds& speed, double dip_share, std::vector<MovementUnit>& bouts) {
  for (std::size_t k = 0; k < bouts.size(); ++k) {
    const double peak = speed[bouts[k].peak];
    if (k == 0) {
      const double slowest = speed[extreme_frame(speed, 0, bouts[k].first, false)];
      bouts[k].begin_confidence *=
          bouts[k].begin_truncated ? 0 : dip_confidence(slowest, peak, dip_share);
    }
    if (k + 1 == bouts.size()) {
      const double slowest = speed[extreme_frame(speed, bouts[k].last, speed.size() - 1, false)];
      bouts[k].end_confidence *=
          bouts[k].end_truncated ? 0 : dip_confidence(slowest, peak, dip_share);
      continue;
    }
    const double slowest = speed[extreme_frame(speed, bouts[k].last, bouts[k + 1].first, false)];
    const double sure =
        dip_confidence(slowest, std::min(peak, speed[bouts[k + 1].peak]), dip_share);
    bouts[k].end_confidence *= sure;
    bouts[k + 1].begin_confidence *= sure;
  }
}

}  // namespace

namespace {

/// Returns the rise of the speed within kReboundWindow_s outside a boundary, up to frame `rest`,
/// relative to the level of the boundary. Near 1, the motion outside might as well belong to the
/// unit.
double rebound(const Speeds& speed, std::size_t edge, std::size_t rest, std::size_t within,
               double level) {
  double least = speed[edge], rise = 0;
  for (std::size_t i = edge, k = 0; i != rest && k < within; ++k) {
    i = rest > edge ? i + 1 : i - 1;
    least = std::min(least, speed[i]);
    rise = std::max(rise, speed[i] - least);
  }
  return rise / level;
}

}  // namespace

void find_boundaries(const HandSignals& signals, const SegmentOptions& options,
                     MovementUnit& bout) {
  const double level = options.onset_share * signals.speed[bout.peak];
  const double part = options.weak_bout_share * signals.speed[bout.peak];
  const SpeedCrossing begin =
      find_speed_crossing(signals, bout.first, bout.first_peak, level, part);
  const SpeedCrossing end = find_speed_crossing(signals, bout.last, bout.last_peak, level, part);
  bout.begin_s = signals.time(begin.frame);
  bout.end_s = signals.time(end.frame);
  bout.begin_confidence = 1 / (1 + std::pow(begin.time_sd_s / kHalfConfidenceSpread_s, 2));
  bout.end_confidence = 1 / (1 + std::pow(end.time_sd_s / kHalfConfidenceSpread_s, 2));
  const auto within = static_cast<std::size_t>(kReboundWindow_s / signals.step_s);
  const double before =
      rebound(signals.speed, signals.frame(bout.begin_s), bout.first, within, level);
  const double after = rebound(signals.speed, signals.frame(bout.end_s), bout.last, within, level);
  bout.begin_confidence /= 1 + before * before;
  bout.end_confidence /= 1 + after * after;
  bout.begin_truncated = begin.frame <= 0;
  bout.end_truncated = end.frame >= static_cast<double>(signals.frames() - 1);
  bout.start_position = signals.position[signals.frame(bout.begin_s)];
  bout.end_position = signals.position[signals.frame(bout.end_s)];
  bout.extent = 0;
  for (std::size_t i = signals.frame(bout.begin_s); i <= signals.frame(bout.end_s); ++i) {
    bout.extent = std::max(bout.extent, (signals.position[i] - bout.start_position).norm());
  }
}

void merge_unit(const HandSignals& signals, const SegmentOptions& options,
                const MovementUnit& other, MovementUnit& bout) {
  if (other.first < bout.first) bout.first_peak = other.first_peak;
  if (other.last > bout.last) bout.last_peak = other.last_peak;
  bout.first = std::min(bout.first, other.first);
  bout.last = std::max(bout.last, other.last);
  if (signals.speed[other.peak] > signals.speed[bout.peak]) bout.peak = other.peak;
  find_boundaries(signals, options, bout);
}

double dip_confidence(double slowest, double smaller_peak, double dip_share) {
  return std::clamp(1 - slowest / (dip_share * smaller_peak), 0.0, 1.0);
}

std::vector<MovementUnit> find_movement_units(const HandSignals& signals,
                                              const SegmentOptions& options,
                                              const std::vector<double>& splits_s) {
  if (signals.frames() == 0) return {};
  std::vector<SpeedInterval> pieces = cut_at_dips(signals, options.dip_share);
  join_over_shallow_dips(signals, options.dip_share, pieces);
  for (const double time_s : splits_s) split_at(signals, time_s, pieces);
  const double least =
      std::max(0.2 * options.min_peak_speed, kMinPeakNoiseRatio * signals.speed_noise);
  std::vector<MovementUnit> units;
  for (const SpeedInterval& piece : pieces) {
    if (signals.speed[piece.peak] < least) continue;
    MovementUnit unit;
    unit.first = piece.first;
    unit.last = piece.last;
    unit.peak = unit.first_peak = unit.last_peak = piece.peak;
    find_boundaries(signals, options, unit);
    if (unit.end_s - unit.begin_s >= kMinUnitDuration_s) units.push_back(unit);
  }
  mark_weak(signals, options, units);
  units = merge_weak_units(signals, options, units);
  extend_by_finger_motion(signals, options, units);
  measure_dips(signals.speed, options.dip_share, units);
  return units;
}

}  // namespace morphe::segment
