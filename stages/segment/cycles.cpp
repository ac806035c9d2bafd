#include "stages/segment/cycles.hpp"

#include <algorithm>
#include <limits>

#include "stages/segment/aperture.hpp"
#include "stages/segment/constants.hpp"

namespace morphe::segment {
namespace {

constexpr double kImpossibleScore = -std::numeric_limits<double>::infinity();

/// The evidence on each unit, taken as a reach.
struct Evidence {
  const HandRecord& hand;
  const std::vector<MovementUnit>& units;
  const std::vector<bool>& leaves;  ///< for the next grasp
  std::vector<ReachAperture> aperture;
  std::vector<bool> carried;  ///< true if an object is carried in the unit
  std::vector<bool> held;     ///< true if an object is held between the unit and the next
};

/// Returns max(−1, 1 − (d / h)²) for the end of `unit`, which is positive at home.
double return_score(const SegmentOptions& options, const MovementUnit& reach,
                    const MovementUnit& unit) {
  const double home_radius = std::min(options.return_radius, reach.displacement().norm() / 2);
  const double ratio = (unit.end_position - reach.start_position).norm() / home_radius;
  return std::max(-1.0, 1 - ratio * ratio);
}

bool is_reach(const SegmentOptions& options, const MovementUnit& unit) {
  if (unit.begin_truncated && unit.peak <= unit.first + kTruncatedPeakFrames) return false;
  if (unit.end_truncated && unit.peak + kTruncatedPeakFrames >= unit.last) return false;
  return unit.displacement().norm() >= options.min_reach_distance;
}

bool approaches_object(const std::vector<SceneObject>& objects, const MovementUnit& reach) {
  return std::ranges::any_of(objects, [&](const SceneObject& object) {
    if (object.time.empty()) return false;
    const Vec3 centre = recorded_pose(object, reach.begin_s).translation();
    return (reach.end_position - centre).norm() <
           kMaxApproachRatio * (reach.start_position - centre).norm();
  });
}

/// Returns the evidence for one movement that consists of units [first, end).
double movement_score(const Evidence& evidence, int first, int end) {
  const bool ends_recording = end == std::ssize(evidence.units);
  const MovementUnit& reach = evidence.units[first];
  if (!is_reach(evidence.hand.options, reach) || (end - first < 2 && !ends_recording))
    return kImpossibleScore;
  const auto leaves = evidence.leaves.begin();
  if (std::find(leaves + first, leaves + end - 1, true) != leaves + end - 1)
    return kImpossibleScore;
  const double home = return_score(evidence.hand.options, reach, evidence.units[end - 1]);
  double sum =
      kMovementScore + (ends_recording || evidence.leaves[end - 1] ? std::max(0.0, home) : home);
  const auto carried = evidence.carried.begin();
  if (std::find(carried + first + 1, carried + end, true) != carried + end) {
    sum += kObjectMovedScore;
  } else if (evidence.held[first]) {
    sum += kGraspScore;
  } else if (evidence.aperture[first].known) {
    sum += evidence.aperture[first].grasps() ? kGraspScore : kNoGraspScore;
  }
  if (evidence.carried[first]) sum -= kObjectMovedScore;
  if (is_known(evidence.hand.shoulder)) {
    const auto horizontal_distance = [&](const Vec3& position) {
      return (position - evidence.hand.shoulder).head<2>().norm();
    };
    const double gained =
        horizontal_distance(reach.end_position) - horizontal_distance(reach.start_position);
    sum += kOutwardScore * gained / reach.displacement().norm();
  }
  if (approaches_object(evidence.hand.objects, reach)) sum += kApproachScore;
  for (int k = first + 1; k + 1 < end; ++k)
    sum -= std::max(0.0, return_score(evidence.hand.options, reach, evidence.units[k]));
  return (end - first) * sum;
}

Evidence gather_evidence(const HandRecord& hand, const std::vector<MovementUnit>& units,
                         const std::vector<bool>& leaves) {
  const HandSignals& signals = hand.signals;
  const SegmentOptions& options = hand.options;
  Evidence evidence{hand, units, leaves, {}, {}, {}};
  for (int k = 0; k < std::ssize(units); ++k) {
    const double next_s = k + 1 < std::ssize(units) ? units[k + 1].begin_s : signals.end_s();
    evidence.aperture.push_back(
        measure_aperture(signals, options, units[k].begin_s, units[k].end_s, next_s));
    evidence.carried.push_back(is_transport(units[k], hand.motions));
    evidence.held.push_back(!longest_held_object(hand.interactions, signals, units[k].end_s, next_s,
                                                 options.min_grasp_s)
                                 .empty());
  }
  return evidence;
}

}  // namespace

bool is_transport(const MovementUnit& unit, const std::vector<ObjectMotion>& motions) {
  return std::ranges::any_of(
      motions, [&](const ObjectMotion& motion) { return overlap_in_time(unit, motion); });
}

std::vector<Cycle> find_cycles(const HandRecord& hand, const std::vector<MovementUnit>& units,
                               const std::vector<bool>& leaves) {
  const SegmentOptions& options = hand.options;
  const Evidence evidence = gather_evidence(hand, units, leaves);
  const int n = static_cast<int>(units.size());
  struct Split {
    double score = kImpossibleScore;  // of the units before this rest
    int last_rest = 0;                // before this one
    bool is_movement = false;         // from last_rest to this one
  };
  std::vector<Split> best(n + 1);  // split up to each rest
  best[0].score = 0;
  const auto offer = [&](int i, int j, double gain, bool is_movement) {
    const double score = best[i].score + gain;
    if (score > best[j].score) best[j] = {score, i, is_movement};
  };
  for (int i = 0; i < n; ++i) {
    offer(i, i + 1, -kSkipPenalty * std::min(1.0, units[i].extent / options.return_radius), false);
    for (int j = i + 1; j <= std::min(n, i + kMaxUnitsPerMovement); ++j) {
      if (i == 0) offer(i, j, units[0].begin_truncated ? 0 : kMissingReachScore, false);
      offer(i, j, movement_score(evidence, i, j), true);
    }
  }
  std::vector<Cycle> cycles;
  for (int j = n; j > 0; j = best[j].last_rest) {
    const int i = best[j].last_rest;
    if (!best[j].is_movement) continue;
    cycles.push_back({i, j - i, return_score(options, units[i], units[j - 1]) > 0, leaves[j - 1]});
  }
  std::ranges::reverse(cycles);
  return cycles;
}

}  // namespace morphe::segment
