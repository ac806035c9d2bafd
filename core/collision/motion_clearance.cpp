#include <algorithm>
#include <limits>

#include "core/collision/motion_pairs.hpp"

namespace morphe::collision {
namespace {

struct ClearanceSearch {
  MotionPairs pairs;
  double resolution_m;
  MotionCheck least;  ///< smallest distance found
  double at_least = std::numeric_limits<double>::infinity();

  /// Follows the pairs in pairs.scratch.undecided_pairs[depth] over [s0, s1] until no pair can come
  /// closer than the smallest distance found, less the resolution.
  void search(std::size_t depth, double s0, double s1) {
    const double middle = 0.5 * (s0 + s1);
    pairs.set_interval(s0, middle, s1);
    std::vector<std::size_t>& further = pairs.scratch.undecided_pairs[depth + 1];
    further.clear();
    const auto nearest = [&] { return least.pair.separation.distance - resolution_m; };
    for (const std::size_t number : pairs.scratch.undecided_pairs[depth]) {
      PairSeparation pair = pairs.pair_of(number);
      if (pairs.may_touch(pair)) continue;
      const double travel_m = pairs.pair_travel(pair);
      double bound_m = pairs.slack_lower_bound(pair) + pair.required_distance_m - travel_m;
      if (!(bound_m >= nearest())) {
        pairs.measure(pair);
        const double distance = pair.separation.distance;
        if (!(distance >= least.pair.separation.distance)) {
          least = {MotionVerdict::free, middle, pair, s0, s1};
        }
        bound_m = distance - travel_m;
        if (bound_m < nearest() && travel_m > 1e-9 && depth + 1 < kMaxBisectionDepth) {
          further.push_back(number);
          continue;
        }
      }
      at_least = std::min(at_least, bound_m);
    }
    if (further.empty()) return;
    search(depth + 1, s0, middle);
    search(depth + 1, middle, s1);
  }
};

}  // namespace

MotionClearance motion_clearance(const CollisionWorld& world, const JointMotion& motion,
                                 CollisionScratch& scratch, double resolution_m) {
  ClearanceSearch nearest{{world, motion, scratch}, resolution_m, {}};
  nearest.least.pair.separation.distance = std::numeric_limits<double>::infinity();
  nearest.least.pair.capsule = -1;
  nearest.least.parameter = motion.begin;
  nearest.pairs.for_each_part([&](double from, double to) {
    nearest.search(0, from, to);
    return true;
  });
  const MotionCheck& least = nearest.least;
  const double distance = least.pair.separation.distance;
  return {std::min(nearest.at_least, distance), distance, least.parameter, least.pair};
}

}  // namespace morphe::collision
