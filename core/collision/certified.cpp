#include "core/collision/certified.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "core/collision/motion_pairs.hpp"

namespace morphe::collision {
namespace {

struct Bisection {
  MotionPairs pairs;
  double band_m;
  bool first_only;
  std::vector<MotionCheck>& failed;
  MotionCheck least;  ///< least slack seen

  /// Judges the pairs in pairs.scratch.open[depth] over [s0, s1]; what stays open goes one level
  /// down.
  void judge(std::size_t depth, double s0, double s1) {
    const double middle = 0.5 * (s0 + s1);
    pairs.place(s0, middle, s1);
    std::vector<std::size_t>& further = pairs.scratch.open[depth + 1];
    further.clear();
    for (const std::size_t number : pairs.scratch.open[depth]) {
      PairSeparation pair = pairs.pair_of(number);
      const double bound_m = pairs.slack_at_least(pair);
      if (bound_m > least.pair.slack() && bound_m >= pairs.travel_of(pair)) continue;
      pairs.measure(pair);
      if (pair.slack() < least.pair.slack()) least = {MotionVerdict::free, middle, pair, s0, s1};
      const double travel_m = pairs.travel_of(pair);
      if (pair.slack() >= travel_m) continue;
      const bool colliding = !(pair.slack() >= 0);  // NaN too
      const bool last = travel_m < band_m || depth + 1 >= kDeepestBisection;
      if (last || (colliding && (first_only || !(pair.slack() >= -travel_m)))) {
        failed.push_back({colliding ? MotionVerdict::colliding : MotionVerdict::undecided, middle,
                          pair, s0, s1});
        if (first_only) return;
      } else {
        further.push_back(number);
      }
    }
    if (further.empty()) return;
    judge(depth + 1, s0, middle);
    if (first_only && !failed.empty()) return;
    judge(depth + 1, middle, s1);
  }

  void decide_all() {
    least.pair.separation.distance = std::numeric_limits<double>::infinity();
    least.pair.capsule = -1;
    least.at = pairs.motion.begin;
    pairs.run([&](double from, double to) {
      judge(0, from, to);
      return !first_only || failed.empty();
    });
  }
};

std::tuple<bool, int, int> key_of(const PairSeparation& pair) {
  return {pair.object, pair.capsule, pair.other};
}

/// Neighbouring intervals of one pair as one, with what was worst.
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
