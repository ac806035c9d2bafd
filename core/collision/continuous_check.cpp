#include "core/collision/continuous_check.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "core/collision/motion_pairs.hpp"

namespace morphe::collision {
namespace {

struct Bisection {
  MotionPairs pairs;
  double resolution_m;
  bool first_only;
  std::vector<MotionCheck>& failed;
  MotionCheck least;  ///< smallest slack found

  /// Checks the pairs in pairs.scratch.undecided_pairs[depth] over [s0, s1]; pairs that remain
  /// undecided are added to the next depth.
  void bisect(std::size_t depth, double s0, double s1) {
    const double middle = 0.5 * (s0 + s1);
    pairs.set_interval(s0, middle, s1);
    std::vector<std::size_t>& further = pairs.scratch.undecided_pairs[depth + 1];
    further.clear();
    for (const std::size_t number : pairs.scratch.undecided_pairs[depth]) {
      PairSeparation pair = pairs.pair_of(number);
      const double bound_m = pairs.slack_lower_bound(pair);
      if (bound_m > least.pair.slack() && bound_m >= pairs.pair_travel(pair)) continue;
      pairs.measure(pair);
      if (pair.slack() < least.pair.slack()) least = {MotionVerdict::free, middle, pair, s0, s1};
      const double travel_m = pairs.pair_travel(pair);
      if (pair.slack() >= travel_m) continue;
      const bool colliding = !(pair.slack() >= 0);  // true for NaN too
      const bool last = travel_m < resolution_m || depth + 1 >= kMaxBisectionDepth;
      if (last || (colliding && (first_only || !(pair.slack() >= -travel_m)))) {
        failed.push_back({colliding ? MotionVerdict::colliding : MotionVerdict::undecided, middle,
                          pair, s0, s1});
        if (first_only) return;
      } else {
        further.push_back(number);
      }
    }
    if (further.empty()) return;
    bisect(depth + 1, s0, middle);
    if (first_only && !failed.empty()) return;
    bisect(depth + 1, middle, s1);
  }

  void decide_all() {
    least.pair.separation.distance = std::numeric_limits<double>::infinity();
    least.pair.capsule = -1;
    least.parameter = pairs.motion.begin;
    pairs.for_each_part([&](double from, double to) {
      bisect(0, from, to);
      return !first_only || failed.empty();
    });
  }
};

std::tuple<bool, int, int> key_of(const PairSeparation& pair) {
  return {pair.other_is_object, pair.capsule, pair.other};
}

/// Merges adjacent intervals of one pair, keeping the worst result.
void join(std::vector<MotionCheck>& found) {
  std::ranges::stable_sort(found, [](const MotionCheck& a, const MotionCheck& b) {
    return std::tuple(key_of(a.pair), a.begin) < std::tuple(key_of(b.pair), b.begin);
  });
  std::vector<MotionCheck> joined;
  for (const MotionCheck& next : found) {
    if (joined.empty() || key_of(joined.back().pair) != key_of(next.pair) ||
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
  found = std::move(joined);
}

}  // namespace

void failing_pairs(const CollisionWorld& world, const JointMotion& motion,
                   CollisionScratch& scratch, std::vector<MotionCheck>& out, double band_m) {
  out.clear();
  Bisection bisection{{world, motion, scratch}, band_m, false, out, {}};
  bisection.decide_all();
  join(out);
}

MotionCheck check_motion(const CollisionWorld& world, const JointMotion& motion,
                         CollisionScratch& scratch, double band_m) {
  std::vector<MotionCheck> failed;
  Bisection bisection{{world, motion, scratch}, band_m, true, failed, {}};
  bisection.decide_all();
  return failed.empty() ? bisection.least : failed.front();
}

}  // namespace morphe::collision
