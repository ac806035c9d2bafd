#include <algorithm>
#include <limits>

#include "core/collision/motion_pairs.hpp"

namespace morphe::collision {
namespace {

struct Approach {
  MotionPairs pairs;
  double resolution_m;
  MotionCheck least;  ///< least distance seen
  double at_least = std::numeric_limits<double>::infinity();

  /// Follows the pairs in pairs.scratch.open[depth] over [s0, s1] until none can come nearer than
  /// what was seen, less the resolution.
  void approach(std::size_t depth, double s0, double s1) {
    const double middle = 0.5 * (s0 + s1);
    pairs.place(s0, middle, s1);
    std::vector<std::size_t>& further = pairs.scratch.open[depth + 1];
    further.clear();
    const auto nearest = [&] { return least.pair.separation.distance - resolution_m; };
    for (const std::size_t number : pairs.scratch.open[depth]) {
      PairSeparation pair = pairs.pair_of(number);
      if (pairs.touches(pair)) continue;
      const double travel_m = pairs.travel_of(pair);
      double bound_m = pairs.slack_at_least(pair) + pair.required - travel_m;
      if (!(bound_m >= nearest())) {
        pairs.measure(pair);
        const double distance = pair.separation.distance;
        if (!(distance >= least.pair.separation.distance)) {
          least = {MotionVerdict::free, middle, pair, s0, s1};
        }
        bound_m = distance - travel_m;
        if (bound_m < nearest() && travel_m > 1e-9 && depth + 1 < kDeepestBisection) {
          further.push_back(number);
          continue;
        }
      }
      at_least = std::min(at_least, bound_m);
    }
    if (further.empty()) return;
    approach(depth + 1, s0, middle);
    approach(depth + 1, middle, s1);
  }
};

}  // namespace

MotionClearance motion_clearance(const CollisionWorld& world, const JointMotion& motion,
                                 CollisionScratch& scratch, double resolution_m) {
  Approach nearest{{world, motion, scratch}, resolution_m, {}};
  nearest.least.pair.separation.distance = std::numeric_limits<double>::infinity();
  nearest.least.pair.capsule = -1;
  nearest.least.at = motion.begin;
  nearest.pairs.run([&](double from, double to) {
    nearest.approach(0, from, to);
    return true;
  });
  const MotionCheck& least = nearest.least;
  const double distance = least.pair.separation.distance;
  return {std::min(nearest.at_least, distance), distance, least.at, least.pair};
}

}  // namespace morphe::collision
