#pragma once

#include <cstdint>

#include "stages/map/map_movement.hpp"
#include "stages/planning/place_movement.hpp"
#include "stages/repair/repair.hpp"

namespace morphe::planning {

/// Joins mapping, check and repair: repair_path() for a movement's plan with findings, whose
/// mapping is re-solved against `world`, the whole scene, and searched again there where the plan's
/// own course leads nowhere.
repair::RepairResult repair_movement(const Planner& planner, const PlacedMovement& placed,
                                     const collision::CollisionWorld& world, const Plan& plan,
                                     const map::MapResult& mapped, std::uint64_t seed);

}  // namespace morphe::planning
