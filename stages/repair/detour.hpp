#pragma once

#include <cstdint>
#include <vector>

#include "core/collision/continuous_check.hpp"
#include "stages/repair/repair_strategy.hpp"

namespace morphe::repair {

/// The context in which detours around collisions are planned and checked. The world must outlive
/// it.
struct DetourContext {
  const collision::CollisionWorld& world;
  RepairOptions options;
  std::uint64_t seed = 0;
  PathCheck check;
  /// strategies that recover the tracking that a detour or a candidate path has lost
  std::vector<RepairStrategy> tracking_recovery;
};

/// Plans around each collision with RRT-Connect between the nearest free samples, with certified
/// edges, first the arm with the fingers in proportion, then all joints. The result is shortened,
/// distributed over the interval's samples and pulled towards the original path as far as it stays
/// free; then `tracking_recovery` is applied. Each attempt searches a wider space. Samples outside
/// the intervals remain bit-identical unless the recovery changes them; planned ones have
/// SampleOrigin::planned. A path with a collision at one of its ends is left unchanged, with the
/// reason. Depends only on its arguments.
StrategyResult detour(const DetourContext& around, const CheckedPath& from);

/// Returns the repair strategy that plans a detour for paths whose only findings are collisions.
RepairStrategy detour_if_only_collisions(const DetourContext& around);

/// Plans the detour from the mapped path instead, for a path that is free of collisions but has
/// other findings.
StrategyResult detour_from_mapped(const CheckedPath& mapped, const DetourContext& around,
                                  const CheckedPath& best);

}  // namespace morphe::repair
