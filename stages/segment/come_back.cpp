#include "stages/segment/come_back.hpp"

#include <algorithm>

#include "core/motion/revisit.hpp"
#include "stages/segment/constants.hpp"

namespace morphe::segment {
namespace {

double distance(const HandSignals& signals, int frame, const Vec3& place) {
  return (signals.position[frame] - place).norm();
}

/// Returns the frame of first … last that is farthest from `place`.
int farthest_frame(const HandSignals& signals, const Vec3& place, int first, int last) {
  int farthest = std::clamp(first, 0, signals.frames() - 1);
  for (int i = farthest; i <= std::min(last, signals.frames() - 1); ++i) {
    if (distance(signals, i, place) > distance(signals, farthest, place)) farthest = i;
  }
  return farthest;
}

double farthest_distance(const HandSignals& signals, const Vec3& place, int first, int last) {
  return distance(signals, farthest_frame(signals, place, first, last), place);
}

double nearest_distance(const HandSignals& signals, const Vec3& place, int first, int last) {
  double nearest = kInfinity;
  for (int i = first; i <= last; ++i) nearest = std::min(nearest, distance(signals, i, place));
  return nearest;
}

/// Returns the score of two stops, -∞ if the hand does not go away from them.
double score_of_stops(const SegmentOptions& options, const Vec3& first, const Vec3& second,
                      double out_m, double away_m) {
  if (std::min(out_m, away_m) < options.min_reach_distance) return -kInfinity;
  return revisit_score(first, second, out_m, away_m);
}

/// Returns true if the hand slows down to a frame, and goes in another direction after it.
bool turns_at(const HandSignals& signals, int frame) {
  const int peak_window = signals.frames_in(kPeakWindow_s), last = signals.frames() - 1;
  const double before_peak =
      signals.speed[fastest_frame(signals, std::max(0, frame - peak_window), frame)];
  const double after_peak =
      signals.speed[fastest_frame(signals, frame, std::min(last, frame + peak_window))];
  if (signals.speed[frame] > kMaxTurnSpeedShare * std::min(before_peak, after_peak)) return false;
  const int window = std::max(1, signals.frames_in(kTurnWindow_s));
  const Vec3& here = signals.position[frame];
  const Vec3 before = here - signals.position[std::max(0, frame - window)];
  const Vec3 after = signals.position[std::min(signals.frames() - 1, frame + window)] - here;
  return before.dot(after) < kMaxTurnCosine * before.norm() * after.norm();
}

/// Returns the frames at which the hand turns.
std::vector<int> find_turns(const HandSignals& signals) {
  const int half = std::max(1, signals.frames_in(kTurnHalfWindow_s));
  std::vector<int> turns;
  for (int i = half; i + half < signals.frames(); ++i) {
    if (slowest_frame(signals, i - half, i + half) == i && turns_at(signals, i)) turns.push_back(i);
  }
  return turns;
}

}  // namespace

ComeBack find_come_back(const HandSignals& signals, const SegmentOptions& options,
                        const MovementUnit& reach, const std::vector<MovementUnit>& units,
                        int next) {
  ComeBack best;
  const Vec3& place = reach.end_position;
  const double out_m = reach.displacement().norm();
  for (int k = next; k + 1 < std::ssize(units); ++k) {
    const double away_m = farthest_distance(signals, place, signals.frame(reach.end_s),
                                            signals.frame(units[k].end_s));
    const double score = score_of_stops(options, place, units[k].end_position, out_m, away_m);
    if (score > -kInfinity && (best.unit < 0 || score > best.score))
      best = {k, std::max(-1.0, score), away_m / out_m};
  }
  return best;
}

std::vector<double> find_passing_turns(const HandSignals& signals, const SegmentOptions& options) {
  std::vector<double> times;
  const int window = signals.frames_in(kComingWindow_s);
  const std::vector<int> turns = find_turns(signals);
  const auto visits_again = [&](int i, int j) {
    const Vec3 &first = signals.position[i], &second = signals.position[j];
    const int origin = farthest_frame(signals, first, i - window, i);
    const double out_m = std::min(distance(signals, origin, first),
                                  farthest_distance(signals, second, j, j + window));
    const double away_m = farthest_distance(signals, first, i, j);
    return score_of_stops(options, first, second, out_m, away_m) > kMinPassingScore &&
           nearest_distance(signals, signals.position[origin], i, j) > out_m / 2;
  };
  for (std::size_t a = 0; a < turns.size(); ++a) {
    for (std::size_t b = a + 1; b < turns.size() && b <= a + kMaxUnitsPerMovement; ++b) {
      if (!visits_again(turns[a], turns[b])) continue;
      times.push_back(signals.time(turns[a]));
      times.push_back(signals.time(turns[b]));
    }
  }
  return times;
}

}  // namespace morphe::segment
