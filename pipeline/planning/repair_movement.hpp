#pragma once

#include <cstdint>

#include "pipeline/planning/place_movement.hpp"
#include "stages/map/map_movement.hpp"
#include "stages/repair/repair_strategy.hpp"

namespace morphe::planning {

/// Returns the world with the required clearance larger by kExtraMargin_m.
collision::CollisionWorld with_extra_margin(collision::CollisionWorld world);

/// Repairs the path of a plan with findings by strategies in order of increasing change. `world`
/// has the whole scene; the strategies ask for kExtraMargin_m more clearance than is required.
///   1. the path is solved again with moderate weights; for a hand alone, whose clearance reaches
///      less far in all strategies, then from bridges over its collisions
///   2. repair ends if an infeasible frame is found (not in joint-to-joint mapping)
///   3. the path is solved again with high weights
///   4. both re-solves for candidate paths through the feasible postures of step 2
///   5. the same for the other candidates of the mapping (`mapped`)
///   6. a detour around the collisions of the best path, then of the mapped path
///   7. re-solves and a detour for candidates of new mapping searches
/// With the method `rrt_connect` only a detour is tried. Samples far from findings remain
/// bit-identical except in candidate paths. Refuses with the reason for which repair ended.
Outcome<repair::RepairResult> repair_movement(const PlanningInputs& planner,
                                              const PlacedMovement& placed,
                                              const collision::CollisionWorld& world,
                                              const Plan& plan, const map::MapResult& mapped,
                                              std::uint64_t seed);

}  // namespace morphe::planning
