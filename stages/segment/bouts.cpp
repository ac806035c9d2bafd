#include "stages/segment/bouts.hpp"

#include <algorithm>
#include <cmath>

#include "stages/segment/edges.hpp"
#include "stages/segment/fingers.hpp"

namespace morphe::segment {
namespace {

using Speeds = std::vector<double>;

constexpr double kDeepest = 0.15;  ///< a dip to this share always separates
constexpr double kLeastBout_s = 0.08;
constexpr double kSplitWithin_s = 0.15;
constexpr double kSpread_s = 0.04;  ///< an edge that is as uncertain as this is half as sure
constexpr double kRebound_s = 0.3;
constexpr std::size_t kNeighbours = 2;

/// A stretch with one or more peaks between two slow points.
struct Piece {
  std::size_t first = 0, last = 0, peak = 0;
};

std::size_t extreme(const Speeds& speed, std::size_t first, std::size_t last, bool fastest) {
  const auto begin = speed.begin() + static_cast<std::ptrdiff_t>(first);
  const auto end = speed.begin() + static_cast<std::ptrdiff_t>(last) + 1;
  const auto at = fastest ? std::max_element(begin, end) : std::min_element(begin, end);
  return static_cast<std::size_t>(at - speed.begin());
}

/// What noise adds to a speed is added everywhere, so that ratios in a rest mean nothing.
double lifted(const HandSignals& signals, std::size_t i) {
  return signals.speed[i] + signals.speed_noise + 1e-6;
}

/// Cuts at every dip below dip_share of the peaks on both sides, in one pass.
std::vector<Piece> cut_at_dips(const HandSignals& signals, double dip_share) {
  std::vector<std::size_t> bounds = {0};
  std::size_t low = 0, high = 0;
  bool rising = false, falling = false;
  for (std::size_t i = 1; i < signals.frames(); ++i) {
    const double v = lifted(signals, i);
    if (v > lifted(signals, high)) high = i;
    if (v < lifted(signals, low)) low = i;
    if (!falling && v < dip_share * lifted(signals, high)) {
      falling = true;
      rising = false;
      low = i;
    } else if (!rising && lifted(signals, low) < dip_share * v) {
      rising = true;
      falling = false;
      if (low > 0) bounds.push_back(low);
      high = i;
    }
  }
  bounds.push_back(falling ? low : signals.frames() - 1);
  std::vector<Piece> pieces;
  for (std::size_t k = 1; k < bounds.size(); ++k) {
    if (bounds[k] <= bounds[k - 1]) continue;
    pieces.push_back(
        {bounds[k - 1], bounds[k], extreme(signals.speed, bounds[k - 1], bounds[k], true)});
  }
  return pieces;
}

/// Above 1: the dip between two pieces is too shallow to separate them.
double shallowness(const HandSignals& signals, const Piece& a, const Piece& b, double dip_share) {
  const auto way = [&](const Piece& piece) -> Vec3 {
    return (signals.position[piece.last] - signals.position[piece.first]).normalized();
  };
  const double allowed =
      std::clamp(dip_share * (1 - way(a).dot(way(b))), std::min(kDeepest, dip_share), dip_share);
  const double smaller = std::min(lifted(signals, a.peak), lifted(signals, b.peak));
  return lifted(signals, a.last) / smaller / allowed;
}

/// Joins pieces over shallow dips, the shallowest of each neighbourhood first.
void join_over_shallow_dips(const HandSignals& signals, double dip_share,
                            std::vector<Piece>& pieces) {
  for (bool changed = true; changed && pieces.size() > 1;) {
    changed = false;
    std::vector<double> shallow(pieces.size() + 1, 0.0);  // of the dip before each piece
    for (std::size_t k = 1; k < pieces.size(); ++k) {
      shallow[k] = shallowness(signals, pieces[k - 1], pieces[k], dip_share);
    }
    std::vector<Piece> joined = {pieces[0]};
    bool just_joined = false;
    for (std::size_t k = 1; k < pieces.size(); ++k) {
      const bool join = !just_joined && shallow[k] > 1 && shallow[k] >= shallow[k - 1] &&
                        shallow[k] >= shallow[k + 1];
      just_joined = join;
      if (!join) {
        joined.push_back(pieces[k]);
        continue;
      }
      Piece& left = joined.back();
      left.last = pieces[k].last;
      if (signals.speed[pieces[k].peak] > signals.speed[left.peak]) left.peak = pieces[k].peak;
      changed = true;
    }
    pieces = std::move(joined);
  }
}

void split_at(const HandSignals& signals, double time_s, std::vector<Piece>& pieces) {
  const std::size_t first = signals.frame(time_s - kSplitWithin_s);
  const std::size_t last = signals.frame(time_s + kSplitWithin_s);
  const std::size_t slowest = extreme(signals.speed, first, last, false);
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const Piece piece = pieces[k];
    if (slowest <= piece.first || slowest >= piece.last) continue;
    const Piece left{piece.first, slowest, extreme(signals.speed, piece.first, slowest, true)};
    const Piece right{slowest, piece.last, extreme(signals.speed, slowest, piece.last, true)};
    const double smaller = std::min(signals.speed[left.peak], signals.speed[right.peak]);
    if (signals.speed[slowest] < kDeepest * smaller) return;  // a rest already
    if (left.peak == slowest || right.peak == slowest) return;
    pieces[k] = left;
    pieces.insert(pieces.begin() + static_cast<std::ptrdiff_t>(k) + 1, right);
    return;
  }
}

void mark_weak(const HandSignals& signals, const SegmentOptions& options,
               std::vector<Bout>& bouts) {
  for (std::size_t k = 0; k < bouts.size(); ++k) {
    double farthest = 0;
    const std::size_t last = std::min(bouts.size() - 1, k + kNeighbours);
    for (std::size_t m = k - std::min(k, kNeighbours); m <= last; ++m) {
      farthest = std::max(farthest, bouts[m].extent);
    }
    bouts[k].weak = bouts[k].extent < options.weak_share * farthest ||
                    signals.speed[bouts[k].peak] < options.least_peak ||
                    only_fingers(signals, bouts[k]);
  }
}

/// How much the weak bout `other` belongs to `bout`: the dip between them over the level at which
/// `bout` would be over, if that or its own peak is high enough; else 0.
double belonging(const HandSignals& signals, const SegmentOptions& options, const Bout& bout,
                 const Bout& other) {
  const bool after = other.peak > bout.peak;
  const std::size_t slowest = after ? extreme(signals.speed, bout.peak, other.peak, false)
                                    : extreme(signals.speed, other.peak, bout.peak, false);
  const double peak = signals.speed[bout.peak], level = options.onset_share * peak;
  const double dip = signals.speed[slowest] / level;
  const std::size_t edge = signals.frame(after ? bout.end_s : bout.begin_s);
  std::size_t near = other.peak;
  while (near != edge && signals.speed[near] >= level) near = after ? near - 1 : near + 1;
  const double gap_s =
      std::abs(signals.time(static_cast<double>(near)) - (after ? bout.end_s : bout.begin_s));
  const bool follows =
      gap_s <= kFollows_s && signals.speed[other.peak] >= options.weak_share * peak;
  return dip >= 1 || follows ? dip + 1e-9 : 0;
}

std::vector<Bout> with_weak_neighbours(const HandSignals& signals, const SegmentOptions& options,
                                       const std::vector<Bout>& bouts) {
  std::vector<Bout> result;
  for (std::size_t k = 0; k < bouts.size(); ++k) {
    if (bouts[k].weak) {
      const bool left = !result.empty() && !result.back().weak;
      const bool right = k + 1 < bouts.size() && !bouts[k + 1].weak;
      const double to_left = left ? belonging(signals, options, result.back(), bouts[k]) : 0;
      const double to_right = right ? belonging(signals, options, bouts[k + 1], bouts[k]) : 0;
      if (to_left > 0 && to_left >= to_right) {
        absorb(signals, options, bouts[k], result.back());
        continue;
      }
      if (to_right > 0) {
        result.push_back(bouts[k + 1]);
        absorb(signals, options, bouts[k], result.back());
        ++k;
        continue;
      }
    }
    result.push_back(bouts[k]);
  }
  return result;
}

void measure_dips(const Speeds& speed, double dip_share, std::vector<Bout>& bouts) {
  for (std::size_t k = 0; k < bouts.size(); ++k) {
    const double peak = speed[bouts[k].peak];
    if (k == 0) {
      const double slowest = speed[extreme(speed, 0, bouts[k].first, false)];
      bouts[k].begin_confidence *=
          bouts[k].cut_begin ? 0 : dip_confidence(slowest, peak, dip_share);
    }
    if (k + 1 == bouts.size()) {
      const double slowest = speed[extreme(speed, bouts[k].last, speed.size() - 1, false)];
      bouts[k].end_confidence *= bouts[k].cut_end ? 0 : dip_confidence(slowest, peak, dip_share);
      continue;
    }
    const double slowest = speed[extreme(speed, bouts[k].last, bouts[k + 1].first, false)];
    const double sure =
        dip_confidence(slowest, std::min(peak, speed[bouts[k + 1].peak]), dip_share);
    bouts[k].end_confidence *= sure;
    bouts[k + 1].begin_confidence *= sure;
  }
}

}  // namespace

namespace {

/// By how much the speed rises again within kRebound_s outside of an edge, up to frame `rest`, over
/// the level of the edge: near 1, what comes then might as well belong to the bout.
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

void find_ends(const HandSignals& signals, const SegmentOptions& options, Bout& bout) {
  const double level = options.onset_share * signals.speed[bout.peak];
  const double part = options.weak_share * signals.speed[bout.peak];
  const Edge begin = find_edge(signals, bout.first, bout.first_part, level, part);
  const Edge end = find_edge(signals, bout.last, bout.last_part, level, part);
  bout.begin_s = signals.time(begin.frame);
  bout.end_s = signals.time(end.frame);
  bout.begin_confidence = 1 / (1 + std::pow(begin.spread_s / kSpread_s, 2));
  bout.end_confidence = 1 / (1 + std::pow(end.spread_s / kSpread_s, 2));
  const auto within = static_cast<std::size_t>(kRebound_s / signals.step_s);
  const double before =
      rebound(signals.speed, signals.frame(bout.begin_s), bout.first, within, level);
  const double after = rebound(signals.speed, signals.frame(bout.end_s), bout.last, within, level);
  bout.begin_confidence /= 1 + before * before;
  bout.end_confidence /= 1 + after * after;
  bout.cut_begin = begin.frame <= 0;
  bout.cut_end = end.frame >= static_cast<double>(signals.frames() - 1);
  bout.from = signals.position[signals.frame(bout.begin_s)];
  bout.to = signals.position[signals.frame(bout.end_s)];
  bout.extent = 0;
  for (std::size_t i = signals.frame(bout.begin_s); i <= signals.frame(bout.end_s); ++i) {
    bout.extent = std::max(bout.extent, (signals.position[i] - bout.from).norm());
  }
}

void absorb(const HandSignals& signals, const SegmentOptions& options, const Bout& other,
            Bout& bout) {
  if (other.first < bout.first) bout.first_part = other.first_part;
  if (other.last > bout.last) bout.last_part = other.last_part;
  bout.first = std::min(bout.first, other.first);
  bout.last = std::max(bout.last, other.last);
  if (signals.speed[other.peak] > signals.speed[bout.peak]) bout.peak = other.peak;
  find_ends(signals, options, bout);
}

double dip_confidence(double slowest, double smaller_peak, double dip_share) {
  return std::clamp(1 - slowest / (dip_share * smaller_peak), 0.0, 1.0);
}

std::vector<Bout> find_bouts(const HandSignals& signals, const SegmentOptions& options,
                             const std::vector<double>& splits_s) {
  if (signals.frames() == 0) return {};
  std::vector<Piece> pieces = cut_at_dips(signals, options.dip_share);
  join_over_shallow_dips(signals, options.dip_share, pieces);
  for (const double time_s : splits_s) split_at(signals, time_s, pieces);
  const double least = std::max(0.2 * options.least_peak, kNoisePeak * signals.speed_noise);
  std::vector<Bout> bouts;
  for (const Piece& piece : pieces) {
    if (signals.speed[piece.peak] < least) continue;
    Bout bout;
    bout.first = piece.first;
    bout.last = piece.last;
    bout.peak = bout.first_part = bout.last_part = piece.peak;
    find_ends(signals, options, bout);
    if (bout.end_s - bout.begin_s >= kLeastBout_s) bouts.push_back(bout);
  }
  mark_weak(signals, options, bouts);
  bouts = with_weak_neighbours(signals, options, bouts);
  take_in_fingers(signals, options, bouts);
  measure_dips(signals.speed, options.dip_share, bouts);
  return bouts;
}

}  // namespace morphe::segment
