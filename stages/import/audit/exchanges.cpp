#include "stages/import/audit/exchanges.hpp"

#include <algorithm>
#include <numeric>

#include "stages/import/audit/constants.hpp"

namespace morphe::imports {
namespace {

/// The last seen sample of a track and its velocity, from which the next sample is predicted.
struct TrackState {
  Vec3 position = unknown_point(), velocity = Vec3::Zero();  ///< [m], [m/s]
  double time_s = kUnknown;

  Vec3 at(double when_s, double max_gap_s) const {
    const double gap_s = when_s - time_s;
    return gap_s <= max_gap_s ? Vec3(position + velocity * gap_s) : unknown_point();
  }
  void add(const Vec3& point, double when_s, double max_gap_s) {
    if (!is_known(point)) return;
    const double step_s = when_s - time_s;
    velocity =
        step_s > 0 && step_s <= max_gap_s ? Vec3((point - position) / step_s) : Vec3(Vec3::Zero());
    position = point;
    time_s = when_s;
  }
};

/// The points of a frame, one for each track, and where the tracks were expected.
struct TrackFrame {
  std::vector<Vec3> seen, expected;

  double jump_m(std::size_t track) const { return (seen[track] - expected[track]).norm(); }
};

std::vector<std::size_t> jumping_tracks(const TrackFrame& frame) {
  std::vector<std::size_t> tracks;
  for (std::size_t k = 0; k < frame.seen.size(); ++k) {
    if (frame.jump_m(k) > kMinExchangeJump_m) tracks.push_back(k);
  }
  return tracks;
}

/// Returns the track whose place the given one takes in this frame, or itself if there is none.
std::size_t continued_in(const TrackFrame& frame, const std::vector<std::size_t>& jumping,
                         std::size_t track) {
  std::size_t nearest = track;
  double distance_m = kMaxExchangeRatio * frame.jump_m(track);
  for (const std::size_t other : jumping) {
    const double apart_m = (frame.seen[other] - frame.expected[track]).norm();
    if (other == track || !(apart_m < distance_m)) continue;
    nearest = other;
    distance_m = apart_m;
  }
  return nearest;
}

/// Keeps the cycles of a map of tracks onto tracks, and makes all other tracks their own.
void keep_cycles(Permutation& next) {
  std::vector<bool> cyclic(next.size());
  for (std::size_t k = 0; k < next.size(); ++k) {
    std::size_t track = next[k];
    for (std::size_t step = 0; step < next.size() && track != k; ++step) track = next[track];
    cyclic[k] = track == k;
  }
  for (std::size_t k = 0; k < next.size(); ++k) {
    if (!cyclic[k]) next[k] = k;
  }
}

Permutation exchange_in(const TrackFrame& frame) {
  Permutation next = identity_permutation(frame.seen.size());
  const std::vector<std::size_t> jumping = jumping_tracks(frame);
  if (jumping.size() < 2) return next;
  for (const std::size_t track : jumping) next[track] = continued_in(frame, jumping, track);
  keep_cycles(next);
  return next;
}

/// Returns the longest time over which a track is predicted [s]: more than one frame in any file.
double max_gap(const std::vector<double>& time) {
  if (time.size() < 2) return kMaxPredictedGap_s;
  const double period_s = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
  return std::max(kMaxPredictedGap_s, kMaxPredictedGap_frames * period_s);
}

}  // namespace

Permutation identity_permutation(std::size_t size) {
  Permutation source(size);
  std::iota(source.begin(), source.end(), std::size_t{0});
  return source;
}

Permutation compose(const Permutation& outer, const Permutation& inner) {
  Permutation source;
  for (const std::size_t track : inner) source.push_back(outer[track]);
  return source;
}

std::vector<std::vector<std::size_t>> cycles_of(const Permutation& source) {
  std::vector<std::vector<std::size_t>> cycles;
  std::vector<bool> visited(source.size());
  for (std::size_t k = 0; k < source.size(); ++k) {
    std::vector<std::size_t> cycle;
    for (std::size_t track = k; !visited[track]; track = source[track]) {
      visited[track] = true;
      cycle.push_back(track);
    }
    if (cycle.size() > 1) cycles.push_back(std::move(cycle));
  }
  return cycles;
}

std::vector<Exchange> find_exchanges(const std::vector<double>& time,
                                     const Array2D<Vec3>& position) {
  std::vector<Exchange> exchanges;
  const double max_gap_s = max_gap(time);
  const Permutation unchanged = identity_permutation(position.cols);
  Permutation source = unchanged;
  std::vector<TrackState> states(position.cols);
  TrackFrame frame{std::vector<Vec3>(position.cols), std::vector<Vec3>(position.cols)};
  for (std::size_t i = 0; i < position.rows; ++i) {
    for (std::size_t k = 0; k < position.cols; ++k) {
      frame.seen[k] = position(i, source[k]);
      frame.expected[k] = states[k].at(time[i], max_gap_s);
    }
    const Permutation exchange = exchange_in(frame);
    if (exchange != unchanged) {
      source = compose(source, exchange);
      exchanges.push_back({i, source});
    }
    for (std::size_t k = 0; k < position.cols; ++k)
      states[k].add(position(i, source[k]), time[i], max_gap_s);
  }
  return exchanges;
}

Array2D<Vec3> undo_exchanges(const std::vector<Exchange>& exchanges,
                             const Array2D<Vec3>& position) {
  Array2D<Vec3> tracks = position;
  for (std::size_t e = 0; e < exchanges.size(); ++e) {
    const std::size_t end = e + 1 < exchanges.size() ? exchanges[e + 1].frame : position.rows;
    for (std::size_t i = exchanges[e].frame; i < end; ++i) {
      for (std::size_t k = 0; k < position.cols; ++k)
        tracks(i, k) = position(i, exchanges[e].source[k]);
    }
  }
  return tracks;
}

Permutation source_at(const std::vector<Exchange>& exchanges, std::size_t frame,
                      std::size_t track_count) {
  const auto after = std::ranges::upper_bound(exchanges, frame, {}, &Exchange::frame);
  return after == exchanges.begin() ? identity_permutation(track_count) : (after - 1)->source;
}

}  // namespace morphe::imports
