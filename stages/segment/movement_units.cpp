#include "stages/segment/movement_units.hpp"

#include <algorithm>
#include <cmath>

#include "stages/segment/constants.hpp"
#include "stages/segment/finger_motion.hpp"

namespace morphe::segment {
namespace {

/// An interval with one or more peaks between two slow points.
struct SpeedInterval {
  int first = 0, last = 0, peak = 0;
};

/// Returns the speed plus the noise, so that two speeds at rest have a ratio near 1 and no dip
/// separates them; the small constant avoids 0 / 0.
double noise_biased_speed(const HandSignals& signals, int i) {
  return signals.speed[i] + signals.speed_noise + 1e-6;
}

/// Cuts at every dip below dip_share of the peaks on both sides, in one pass.
std::vector<SpeedInterval> cut_at_dips(const HandSignals& signals, double dip_share) {
  std::vector<int> bounds = {0};
  int low = 0, high = 0;  // slowest and fastest frame since the last cut
  bool rising = false, falling = false;
  for (int i = 1; i < signals.frames(); ++i) {
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
  for (int k = 1; k < std::ssize(bounds); ++k) {
    const int first = bounds[k - 1], last = bounds[k];
    if (last > first) pieces.push_back({first, last, fastest_frame(signals, first, last)});
  }
  return pieces;
}

/// Returns the dip between two intervals relative to the allowed one. Above 1, the dip is too
/// dip_ratios to separate them.
double dip_ratio(const HandSignals& signals, const SpeedInterval& a, const SpeedInterval& b,
                 double dip_share) {
  const auto direction = [&](const SpeedInterval& piece) -> Vec3 {
    return (signals.position[piece.last] - signals.position[piece.first]).normalized();
  };
  const double allowed = std::clamp(dip_share * (1 - direction(a).dot(direction(b))),
                                    std::min(kSeparatingDipShare, dip_share), dip_share);
  const double smaller =
      std::min(noise_biased_speed(signals, a.peak), noise_biased_speed(signals, b.peak));
  return noise_biased_speed(signals, a.last) / smaller / allowed;
}

/// Joins intervals over dips with a ratio above 1, the shallowest of each neighbourhood first.
void join_over_shallow_dips(const HandSignals& signals, double dip_share,
                            std::vector<SpeedInterval>& pieces) {
  for (bool changed = true; changed && pieces.size() > 1;) {
    changed = false;
    std::vector<double> dip_ratios(pieces.size() + 1, 0.0);  // of the dip before each interval
    for (int k = 1; k < std::ssize(pieces); ++k)
      dip_ratios[k] = dip_ratio(signals, pieces[k - 1], pieces[k], dip_share);
    std::vector<SpeedInterval> joined = {pieces[0]};
    bool just_joined = false;
    for (int k = 1; k < std::ssize(pieces); ++k) {
      const bool join = !just_joined && dip_ratios[k] > 1 && dip_ratios[k] >= dip_ratios[k - 1] &&
                        dip_ratios[k] >= dip_ratios[k + 1];
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

/// Cuts the interval around the slowest frame near `time_s` in two, if that frame is inside it, not
/// a rest and not the peak of a part.
void split_at(const HandSignals& signals, double time_s, std::vector<SpeedInterval>& pieces) {
  const int cut = slowest_frame(signals, signals.frame(time_s - kSplitHalfWindow_s),
                                signals.frame(time_s + kSplitHalfWindow_s));
  const auto piece = std::ranges::find_if(pieces, [&](const SpeedInterval& interval) {
    return cut > interval.first && cut < interval.last;
  });
  if (piece == pieces.end()) return;
  const SpeedInterval left{piece->first, cut, fastest_frame(signals, piece->first, cut)};
  const SpeedInterval right{cut, piece->last, fastest_frame(signals, cut, piece->last)};
  const double smaller_peak = std::min(signals.speed[left.peak], signals.speed[right.peak]);
  if (signals.speed[cut] < kSeparatingDipShare * smaller_peak) return;  // cut_at_dips() has decided
  if (left.peak == cut || right.peak == cut) return;
  *piece = left;
  pieces.insert(piece + 1, right);
}

void mark_weak(const HandSignals& signals, const SegmentOptions& options,
               std::vector<MovementUnit>& units) {
  const std::ptrdiff_t count = std::ssize(units);
  for (int k = 0; k < count; ++k) {
    double farthest = 0;
    for (int m = std::max(k - kWeakNeighbours, 0); m < count && m <= k + kWeakNeighbours; ++m)
      farthest = std::max(farthest, units[m].extent);
    units[k].weak = units[k].extent < options.weak_unit_share * farthest ||
                    signals.speed[units[k].peak] < options.min_peak_speed ||
                    is_finger_motion(signals, units[k]);
  }
}

/// Returns the score for merging the weak unit `other` into `unit`: 0 if they are not to be merged,
/// otherwise the dip between them over the level at which `unit` ends, made positive by 1e-9.
double merge_score(const HandSignals& signals, const SegmentOptions& options,
                   const MovementUnit& unit, const MovementUnit& other) {
  const bool after = other.peak > unit.peak;
  const int slowest = after ? slowest_frame(signals, unit.peak, other.peak)
                            : slowest_frame(signals, other.peak, unit.peak);
  const double peak = signals.speed[unit.peak], level = options.onset_share * peak;
  const double dip = signals.speed[slowest] / level;
  const double boundary_s = after ? unit.end_s : unit.begin_s;
  const int boundary = signals.frame(boundary_s);
  int facing = other.peak;  // frame at which `other` has slowed down towards `unit`
  while (facing != boundary && signals.speed[facing] >= level) facing += after ? -1 : 1;
  const double gap_s = std::abs(signals.time(facing) - boundary_s);
  const bool follows =
      gap_s <= kMaxMergeGap_s && signals.speed[other.peak] >= options.weak_unit_share * peak;
  return dip >= 1 || follows ? dip + 1e-9 : 0;
}

std::vector<MovementUnit> merge_weak_units(const HandSignals& signals,
                                           const SegmentOptions& options,
                                           const std::vector<MovementUnit>& units) {
  std::vector<MovementUnit> result;
  for (int k = 0; k < std::ssize(units); ++k) {
    if (units[k].weak) {
      const bool left = !result.empty() && !result.back().weak;
      const bool right = k + 1 < std::ssize(units) && !units[k + 1].weak;
      const double to_left = left ? merge_score(signals, options, result.back(), units[k]) : 0;
      const double to_right = right ? merge_score(signals, options, units[k + 1], units[k]) : 0;
      if (to_left > 0 && to_left >= to_right) {
        merge_unit(signals, options, units[k], result.back());
        continue;
      }
      if (to_right > 0) {
        result.push_back(units[k + 1]);
        merge_unit(signals, options, units[k], result.back());
        ++k;
        continue;
      }
    }
    result.push_back(units[k]);
  }
  return result;
}

/// Returns 1 − slowest / (dip_share · smaller_peak), clamped to 0 … 1.
double dip_confidence(double slowest, double smaller_peak, double dip_share) {
  return std::clamp(1 - slowest / (dip_share * smaller_peak), 0.0, 1.0);
}

/// Multiplies the confidences of the boundaries by that of the pauses at them.
void weigh_by_dips(const HandSignals& signals, double dip_share, std::vector<MovementUnit>& units) {
  const auto slowest = [&](int first, int last) {
    return signals.speed[slowest_frame(signals, first, last)];
  };
  if (units.empty()) return;
  MovementUnit &first = units.front(), &last = units.back();
  first.begin_confidence *=
      first.begin_truncated
          ? 0
          : dip_confidence(slowest(0, first.first), signals.speed[first.peak], dip_share);
  for (int k = 0; k + 1 < std::ssize(units); ++k) {
    MovementUnit &before = units[k], &after = units[k + 1];
    const double smaller_peak = std::min(signals.speed[before.peak], signals.speed[after.peak]);
    const double confidence =
        dip_confidence(slowest(before.last, after.first), smaller_peak, dip_share);
    before.end_confidence *= confidence;
    after.begin_confidence *= confidence;
  }
  last.end_confidence *= last.end_truncated
                             ? 0
                             : dip_confidence(slowest(last.last, signals.frames() - 1),
                                              signals.speed[last.peak], dip_share);
}

}  // namespace

std::vector<MovementUnit> find_movement_units(const HandSignals& signals,
                                              const SegmentOptions& options,
                                              const std::vector<double>& splits_s) {
  if (signals.frames() == 0) return {};
  std::vector<SpeedInterval> pieces = cut_at_dips(signals, options.dip_share);
  join_over_shallow_dips(signals, options.dip_share, pieces);
  for (const double time_s : splits_s) split_at(signals, time_s, pieces);
  const double min_peak = std::max(kMinPartSpeedShare * options.min_peak_speed,
                                   kMinPeakNoiseRatio * signals.speed_noise);
  std::vector<MovementUnit> units;
  for (const SpeedInterval& piece : pieces) {
    if (signals.speed[piece.peak] < min_peak) continue;
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
  weigh_by_dips(signals, options.dip_share, units);
  return units;
}

}  // namespace morphe::segment
