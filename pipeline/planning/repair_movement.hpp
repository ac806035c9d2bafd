#pragma once

#include <cstdint>

#include "pipeline/planning/place_movement.hpp"
#include "stages/map/map_movement.hpp"
#include "stages/repair/ladder.hpp"

namespace morphe::planning {

/// A repaired path keeps 0.2 mm more than the margin where it can: the curve through it is
/// smoothed, and certified to a tenth of a millimetre.
collision::CollisionWorld with_room(collision::CollisionWorld world);

/// Joins mapping, check and repair: the smallest change that makes a movement's plan free, the
/// least first. Its mapping is re-solved against `world`, the whole scene, gently; nothing more if
/// that leaves a dead end; then firmly; then likewise other courses, through free postures and
/// those of the mapping; then a detour, also from the mapped path; at last all of that from courses
/// searched in the whole scene. Samples far from findings keep their bits but in other courses.
Outcome<repair::RepairResult> repair_movement(const Planner& planner, const PlacedMovement& placed,
                                              const collision::CollisionWorld& world,
                                              const Plan& plan, const map::MapResult& mapped,
                                              std::uint64_t seed);

}  // namespace morphe::planning
