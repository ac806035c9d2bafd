#pragma once

#include <cstdint>

#include "pipeline/planning/place_movement.hpp"
#include "stages/map/map_movement.hpp"
#include "stages/repair/repair_strategy.hpp"

namespace morphe::planning {

/// Returns the world with a margin of additional 0.2 mm, which a repaired path keeps if it can,
/// because the curve through it is smoothed and certified to a tenth of a millimetre.
collision::CollisionWorld with_extra_margin(collision::CollisionWorld world);

/// Connects mapping, check and repair: finds the smallest change that frees a movement's plan by
/// trying the strategies in order of increasing change. Its mapping is solved again in `world`, the
/// whole scene, with moderate weights; repair ends if an infeasible frame remains; then with high
/// weights; then the same for candidate paths through free postures and those of the mapping; then
/// a detour, also from the mapped path; finally all of this for candidates searched in the whole
/// scene. Samples far from findings remain bit-identical except in candidate paths.
Outcome<repair::RepairResult> repair_movement(const PlanningInputs& planner,
                                              const PlacedMovement& placed,
                                              const collision::CollisionWorld& world,
                                              const Plan& plan, const map::MapResult& mapped,
                                              std::uint64_t seed);

}  // namespace morphe::planning
