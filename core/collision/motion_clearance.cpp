#include <algorithm>
#include <array>

#include "core/collision/continuous_check.hpp"
#include "core/collision/motion_pairs.hpp"

namespace morphe::collision {
namespace {

/// The least clearance found so far.
struct Least {
  PairSeparation closest = no_pair();  ///< the pair with the smallest distance measured
  double parameter = 0;                ///< at which it was measured
  double lower_bound_m = kInfinity;    ///< of pairs that were excluded or measured
};

struct ClearanceSearch {
  MotionPairs pairs;
  double resolution_m;
  std::array<Least, kClearanceKindCount> least;

  Least& least_of(const BodyPair& pair) {
    return least[static_cast<std::size_t>(kind_of(pairs.world, pair))];
  }

  /// Searches [s0, s1] for distances that are smaller than that of the closest pair of their kind
  /// by more than the resolution, among the pairs in scratch.undecided_pairs[depth]. Lowers
  /// lower_bound_m for the others.
  void search(int depth, double s0, double s1) {
    const double middle = 0.5 * (s0 + s1);
    pairs.set_interval(s0, middle, s1);
    if (depth == 0) pairs.list_pairs([](double, double) { return false; });
    std::vector<BodyPair>& undecided = pairs.scratch.undecided_pairs[depth + 1];
    undecided.clear();
    for (const BodyPair& bodies : pairs.scratch.undecided_pairs[depth]) {
      PairSeparation pair = pairs.unmeasured(bodies);
      if (pairs.may_touch(pair)) continue;
      auto& [closest, parameter, lower_bound_m] = least_of(pair);
      const double travel_m = pairs.pair_travel(pair);
      double bound_m = pairs.slack_lower_bound(pair) + pair.required_distance_m - travel_m;
      if (!(bound_m >= closest.separation.distance - resolution_m)) {
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

ClearanceKind kind_of(const CollisionWorld& world, const BodyPair& pair) {
  if (!pair.other_is_object) return ClearanceKind::self;
  if (pair.other == world.target) return ClearanceKind::target;
  const bool table = world.scene->objects[pair.other].name == kTableName;
  return table ? ClearanceKind::table : ClearanceKind::objects;
}

std::array<MotionClearance, kClearanceKindCount> clearance_by_kind(const CollisionWorld& world,
                                                                   const JointMotion& motion,
                                                                   CollisionScratch& scratch,
                                                                   double resolution_m) {
  ClearanceSearch search{{world, motion, scratch}, resolution_m, {}};
  search.pairs.for_each_part([&](double from, double to) {
    search.search(0, from, to);
    return true;
  });
  std::array<MotionClearance, kClearanceKindCount> result;
  for (int k = 0; k < kClearanceKindCount; ++k) {
    const auto& [closest, parameter, lower_bound_m] = search.least[k];
    const double distance = closest.separation.distance;
    result[k] = {std::min(lower_bound_m, distance), distance, parameter, closest};
  }
  return result;
}

MotionClearance motion_clearance(const CollisionWorld& world, const JointMotion& motion,
                                 CollisionScratch& scratch, double resolution_m) {
  const auto all = clearance_by_kind(world, motion, scratch, resolution_m);
  return *std::ranges::min_element(all, {}, &MotionClearance::lower_bound_m);
}

}  // namespace morphe::collision
