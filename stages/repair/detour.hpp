#pragma once

#include <cstdint>
#include <vector>

#include "core/collision/certified.hpp"
#include "stages/repair/ladder.hpp"

namespace morphe::repair {

/// What a way around collisions is planned in, and checked by. The world must outlive it.
struct Surroundings {
  const collision::CollisionWorld& world;
  RepairOptions options;
  std::uint64_t seed = 0;
  Check check;
  /// Rungs that win back what a way around, or another course, cost in tracking.
  std::vector<Rung> win_back;
};

/// Around each collision, an RRT-Connect between the nearest free samples with certified edges, the
/// arm first and the fingers in proportion, then all joints; shortened, spread over the interval's
/// samples and drawn back to the original path as far as it stays free; then `win_back`. More
/// widely in each attempt. Samples outside the intervals keep their bits unless they are won back;
/// planned ones are Origin::planned. A path that collides at one of its ends is left as it is, with
/// the reason. Depends on its arguments alone.
Made detour(const Surroundings& around, const Checked& from);

/// The rung of a detour for paths that nothing but collisions is wrong with.
Rung detour_where_all_collide(const Surroundings& around);

/// For a path that is free but not where it should be: the detour from the mapped path instead.
Made detour_from(const Checked& mapped, const Surroundings& around, const Checked& best);

}  // namespace morphe::repair
