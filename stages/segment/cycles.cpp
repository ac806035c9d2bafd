#include "stages/segment/cycles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/math/statistics.hpp"
#include "stages/segment/aperture.hpp"

namespace morphe::segment {
namespace {

constexpr std::size_t kMaxUnitsPerMovement = 12;
constexpr double kImpossibleScore = -std::numeric_limits<double>::infinity();
constexpr double kMovementScore = 0.25;      ///< for any movement
constexpr double kMissingReachScore = -0.1;  ///< for a movement without its reach
constexpr double kObjectMovedScore = 1, kGraspScore = 0.5, kNoGraspScore = -0.5;
constexpr double kOutwardScore = 1, kApproachScore = 0.25, kSkipPenalty = 1;

struct Evidence {
  const HandSignals& signals;
  const SegmentOptions& options;
  const std::vector<MovementUnit>& bouts;
  const std::vector<SceneObject>& objects;
  std::vector<ReachAperture> opening;  ///< aperture of each unit, taken as a reach
  std::vector<bool> carried;           ///< true for each unit in which an object is carried
  std::vector<bool> held;              ///< true if an object is held after the unit
  Vec3 shoulder;                       ///< median position of the shoulder, or unseen
};

/// Returns 1 − (d / h)², which is positive at home.
double return_score(const SegmentOptions& options, const MovementUnit& reach,
                    const MovementUnit& bout) {
  const double way = (reach.end_position - reach.start_position).norm();
  const double away =
      (bout.end_position - reach.start_position).norm() / std::min(options.return_radius, way / 2);
  return std::max(-1.0, 1 - away * away);
}

bool is_reach(const SegmentOptions& options, const MovementUnit& bout) {
  if (bout.begin_truncated && bout.peak <= bout.first + 2) return false;
  if (bout.end_truncated && bout.peak + 2 >= bout.last) return false;
  return (bout.end_position - bout.start_position).norm() >= options.min_reach_distance;
}

bool approaches_object(const Evidence& on, const MovementUnit& reach) {
  return std::any_of(on.objects.begin(), on.objects.end(), [&](const SceneObject& object) {
    if (object.time.empty()) return false;
    const Vec3 at = recorded_pose(object, reach.begin_s).translation();
    return (reach.end_position - at).norm() < 0.5 * (reach.start_position - at).norm();
  });
}

/// Returns the evidence for one movement that consists of units [first, end).
double movement_score(const Evidence& on, std::size_t first, std::size_t end) {
  const bool last = end == on.bouts.size();
  if (!is_reach(on.options, on.bouts[first]) || (end - first < 2 && !last)) return kImpossibleScore;
  const MovementUnit& reach = on.bouts[first];
  const double home = return_score(on.options, reach, on.bouts[end - 1]);
  double sum = kMovementScore + (last ? std::max(0.0, home) : home);
  const auto carried = on.carried.begin();
  const bool moved = std::any_of(carried + first + 1, carried + end, [](bool c) { return c; });
  if (moved) {
    sum += kObjectMovedScore;
  } else if (on.held[first]) {
    sum += kGraspScore;
  } else if (on.opening[first].known) {
    sum += on.opening[first].grasps() ? kGraspScore : kNoGraspScore;
  }
  if (on.carried[first]) sum -= kObjectMovedScore;
  if (is_known(on.shoulder)) {
    const auto level_distance = [&](const Vec3& from) {
      return (from - on.shoulder).head<2>().norm();
    };
    const double gained = level_distance(reach.end_position) - level_distance(reach.start_position);
    sum += kOutwardScore * gained / (reach.end_position - reach.start_position).norm();
  }
  if (approaches_object(on, reach)) sum += kApproachScore;
  for (std::size_t k = first + 1; k + 1 < end; ++k) {
    sum -= std::max(0.0, return_score(on.options, on.bouts[first], on.bouts[k]));
  }
  return static_cast<double>(end - first) * sum;
}

Evidence gather_evidence(const HandSignals& signals, const HumanMotion& motion,
                         const SegmentOptions& options, const std::vector<MovementUnit>& bouts,
                         const std::vector<SceneObject>& objects,
                         const std::vector<ObjectMotion>& motions,
                         const std::vector<HandObjectInteraction>& contacts) {
  Evidence evidence{signals, options, bouts, objects,
                    {},      {},      {},    math::median_point(motion.shoulder)};
  for (std::size_t k = 0; k < bouts.size(); ++k) {
    const double next_s = k + 1 < bouts.size() ? bouts[k + 1].begin_s : signals.end_s();
    evidence.opening.push_back(
        measure_aperture(signals, options, bouts[k].begin_s, bouts[k].end_s, next_s));
    evidence.carried.push_back(is_transport(bouts[k], motions));
    const std::string held =
        longest_held_object(contacts, signals, bouts[k].end_s, next_s, options.min_grasp_s);
    evidence.held.push_back(!held.empty());
  }
  return evidence;
}

}  // namespace

bool is_transport(const MovementUnit& bout, const std::vector<ObjectMotion>& motions) {
  return std::any_of(motions.begin(), motions.end(), [&](const ObjectMotion& motion) {
    const double common =
        std::min(bout.end_s, motion.end_s) - std::max(bout.begin_s, motion.begin_s);
    return common > 0.5 * std::min(bout.end_s - bout.begin_s, motion.end_s - motion.begin_s);
  });
}

std::vector<Cycle> find_cycles(const HandSignals& signals, const HumanMotion& motion,
                               const SegmentOptions& options,
                               const std::vector<MovementUnit>& bouts,
                               const std::vector<SceneObject>& objects,
                               const std::vector<ObjectMotion>& motions,
                               const std::vector<HandObjectInteraction>& contacts) {
  const Evidence evidence =
      gather_evidence(signals, motion, options, bouts, objects, motions, contacts);
  const std::size_t n = bouts.size();
  struct Best {
    double sum = kImpossibleScore;
    std::size_t from = 0;
    bool movement = false;
  };
  std::vector<Best> best(n + 1);
  best[0].sum = 0;
  const auto offer = [&](std::size_t from, std::size_t to, double gain, bool movement) {
    const double sum = best[from].sum + gain;
    if (sum > best[to].sum) best[to] = {sum, from, movement};
  };
  for (std::size_t i = 0; i < n; ++i) {
    offer(i, i + 1, -kSkipPenalty * std::min(1.0, bouts[i].extent / options.return_radius), false);
    for (std::size_t j = i + 1; j <= std::min(n, i + kMaxUnitsPerMovement); ++j) {
      if (i == 0) offer(i, j, bouts[0].begin_truncated ? 0 : kMissingReachScore, false);
      offer(i, j, movement_score(evidence, i, j), true);
    }
  }
  std::vector<Cycle> cycles;
  for (std::size_t j = n; j > 0; j = best[j].from) {
    const std::size_t i = best[j].from;
    if (!best[j].movement) continue;
    const double home = return_score(options, bouts[i], bouts[j - 1]);
    cycles.push_back({i, j - i, home > 0});
  }
  std::reverse(cycles.begin(), cycles.end());
  return cycles;
}

}  // namespace morphe::segment
