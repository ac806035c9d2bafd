#include <algorithm>

#include "core/collision/continuous_check.hpp"
#include "core/collision/motion_pairs.hpp"

namespace morphe::collision {
namespace {

struct ClearanceSearch {
  MotionPairs pairs;
  double resolution_m;
  PairSeparation closest;  ///< the pair with the smallest distance found
  double parameter;        ///< at which it was found
  double lower_bound_m = kInfinity;

  /// Searches [s0, s1] for distances smaller than that of `closest` by more than the resolution,
  /// among the pairs in scratch.undecided_pairs[depth]. Lowers lower_bound_m for the others.
  void search(int depth, double s0, double s1) {
    const double middle = 0.5 * (s0 + s1);
    pairs.set_interval(s0, middle, s1);
    const double margin_m = pairs.world.tolerances.required_clearance;
    if (depth == 0) {
      pairs.list_pairs([&](double slack_m, double travel_m) {
        return slack_m + margin_m - travel_m >= closest.separation.distance;
      });
    }
    std::vector<BodyPair>& undecided = pairs.scratch.undecided_pairs[depth + 1];
    undecided.clear();
    const auto is_excluded = [&](double bound_m) {
      return bound_m >= closest.separation.distance - resolution_m;
    };
    for (const BodyPair& bodies : pairs.scratch.undecided_pairs[depth]) {
      PairSeparation pair = pairs.unmeasured(bodies);
      if (pairs.may_touch(pair)) continue;
      const double travel_m = pairs.pair_travel(pair);
      double bound_m = pairs.slack_lower_bound(pair) + pair.required_distance_m - travel_m;
      if (!is_excluded(bound_m)) {
        measure(pairs.world, pairs.scratch, pair);
        if (!(pair.separation.distance >= closest.separation.distance)) {
          closest = pair;
          parameter = middle;
        }
        bound_m = pair.separation.distance - travel_m;
        if (bound_m < closest.separation.distance - resolution_m && travel_m > kMinTravel_m &&
            depth + 1 < kMaxBisectionDepth) {
          undecided.push_back(bodies);
          continue;
        }
      }
      lower_bound_m = std::min(lower_bound_m, bound_m);
    }
    if (undecided.empty()) return;
    search(depth + 1, s0, middle);
    search(depth + 1, middle, s1);
  }
};

}  // namespace

MotionClearance motion_clearance(const CollisionWorld& world, const JointMotion& motion,
                                 CollisionScratch& scratch, double resolution_m) {
  ClearanceSearch search{{world, motion, scratch}, resolution_m, no_pair(), motion.begin};
  search.pairs.for_each_part([&](double from, double to) {
    search.search(0, from, to);
    return true;
  });
  const double distance = search.closest.separation.distance;
  return {std::min(search.lower_bound_m, distance), distance, search.parameter, search.closest};
}

}  // namespace morphe::collision
