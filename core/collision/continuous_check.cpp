#include "core/collision/continuous_check.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "core/collision/motion_pairs.hpp"

namespace morphe::collision {
namespace {

struct Bisection {
  MotionPairs pairs;
  double resolution_m;
  bool first_only;
  std::vector<MotionCheck>& failed;
  MotionCheck least_slack;  ///< the check with the smallest slack

  /// Checks the pairs in scratch.undecided_pairs[depth] over [s0, s1]; adds failures to `failed`.
  void bisect(int depth, double s0, double s1) {
    const double middle = 0.5 * (s0 + s1);
    pairs.set_interval(s0, middle, s1);
    const auto is_free = [&](double slack_m, double travel_m) {
      return slack_m > least_slack.pair.slack() && slack_m >= travel_m;
    };
    if (depth == 0) pairs.list_pairs(is_free);
    std::vector<BodyPair>& undecided = pairs.scratch.undecided_pairs[depth + 1];
    undecided.clear();
    for (const BodyPair& bodies : pairs.scratch.undecided_pairs[depth]) {
      PairSeparation pair = pairs.unmeasured(bodies);
      const double bound_m = pairs.slack_lower_bound(pair);
      if (bound_m > least_slack.pair.slack() && bound_m >= pairs.pair_travel(pair)) continue;
      measure(pairs.world, pairs.scratch, pair);
      if (pair.slack() < least_slack.pair.slack())
        least_slack = {MotionVerdict::free, middle, pair, s0, s1};
      const double travel_m = pairs.pair_travel(pair);
      if (pair.slack() >= travel_m) continue;
      const bool colliding = !(pair.slack() >= 0);  // true for NaN too
      const bool is_final = travel_m < resolution_m || depth + 1 >= kMaxBisectionDepth;
      if (is_final || (colliding && (first_only || !(pair.slack() >= -travel_m)))) {
        failed.push_back({colliding ? MotionVerdict::colliding : MotionVerdict::undecided, middle,
                          pair, s0, s1});
        if (first_only) return;
      } else {
        undecided.push_back(bodies);
      }
    }
    if (undecided.empty()) return;
    bisect(depth + 1, s0, middle);
    if (first_only && !failed.empty()) return;
    bisect(depth + 1, middle, s1);
  }

  void check_all() {
    least_slack.pair = no_pair();
    least_slack.parameter = pairs.motion.begin;
    pairs.for_each_part([&](double from, double to) {
      bisect(0, from, to);
      return !first_only || failed.empty();
    });
  }
};

/// Merges adjacent intervals of one pair, keeping the result with the smaller slack.
void join(std::vector<MotionCheck>& failed) {
  std::ranges::stable_sort(failed, {}, [](const MotionCheck& check) {
    return std::tuple(check.pair.key(), check.begin);
  });
  std::vector<MotionCheck> joined;
  for (const MotionCheck& next : failed) {
    if (joined.empty() || joined.back().pair.key() != next.pair.key() ||
        joined.back().end < next.begin) {
      joined.push_back(next);
      continue;
    }
    MotionCheck& last = joined.back();
    const double end = std::max(last.end, next.end);
    if (!(next.pair.slack() >= last.pair.slack())) {
      const double begin = last.begin;
      last = next;
      last.begin = begin;
    }
    last.end = end;
  }
  failed = std::move(joined);
}

}  // namespace

void failing_pairs(const CollisionWorld& world, const JointMotion& motion,
                   CollisionScratch& scratch, std::vector<MotionCheck>& out, double band_m) {
  out.clear();
  Bisection bisection{{world, motion, scratch}, band_m, false, out, {}};
  bisection.check_all();
  join(out);
}

MotionCheck check_motion(const CollisionWorld& world, const JointMotion& motion,
                         CollisionScratch& scratch, double band_m) {
  std::vector<MotionCheck> failed;
  Bisection bisection{{world, motion, scratch}, band_m, true, failed, {}};
  bisection.check_all();
  return failed.empty() ? bisection.least_slack : failed.front();
}

}  // namespace morphe::collision
