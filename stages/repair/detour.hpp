#pragma once

#include <cstdint>
#include <vector>

#include "core/collision/continuous_check.hpp"
#include "stages/repair/repair_strategy.hpp"

namespace morphe::repair {

/// The context in which detours around collisions are planned and checked.
struct DetourContext {
  const collision::CollisionWorld& world;  ///< must outlive the context
  RepairOptions options;
  std::uint64_t seed = 0;
  PathCheck check;
  std::vector<RepairStrategy> tracking_recovery;  ///< applied to each detour, which loses tracking
};

/// Plans around each collision of a path with RRT-Connect, between the nearest free samples and
/// with certified edges: first the arm with the fingers in proportion, then all joints. The result
/// is shortened, distributed over the interval's samples and pulled towards the original path as
/// far as it stays free. Then `tracking_recovery` is applied. Each attempt searches a wider space.
/// Samples outside the intervals remain bit-identical unless the recovery changes them. A path that
/// collides at its start or end is returned unchanged with a failure, one without a collision with
/// a stop_reason. The result depends only on the arguments.
StrategyResult detour(const DetourContext& context, const CheckedPath& start);

/// Returns the repair strategy that plans a detour for paths whose only findings are collisions.
RepairStrategy detour_if_only_collisions(const DetourContext& context);

/// Plans the detour from the mapped path, if `best` has no collisions (but other findings). It
/// never fails: `best` remains if the mapped path has no detour.
StrategyResult detour_from_mapped(const CheckedPath& mapped, const DetourContext& context,
                                  const CheckedPath& best);

}  // namespace morphe::repair
