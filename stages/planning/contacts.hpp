#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/collision/world.hpp"
#include "stages/map/map_movement.hpp"
#include "stages/planning/planner.hpp"

namespace morphe::planning {

struct PlacedMovement;

/// Whether the goals of a movement ask for pads on what it grasps, or for tips near it.
struct Contacts {
  bool asked = false;
  std::vector<std::string> given_up;  ///< tips that stay without
};

/// What a plan is judged by: with contacts, pads sink in by grasp.penetration at most.
Tolerances tolerances_of(const PipelineConfig& config, const Contacts& contacts);

/// Turns the goals of the tips that touched the target into goals of pads.
void touch_target(const Planner& planner, const Movement& movement, const Contacts& contacts,
                  PlacedMovement& placed);

/// Closes the fingers without goals onto the target, from where the mapped hand has taken it.
void close_other_fingers(const Planner& planner, const collision::CollisionWorld& world,
                         const std::vector<std::string>& given_up, std::uint64_t seed, Plan& plan,
                         PlacedMovement& placed, map::MapResult& mapped);

/// Tips with contacts that findings speak of: they are away from their goals, or their links
/// collide.
std::vector<std::string> tips_in_the_way(const robot::Robot& robot, const Goals& goals,
                                         const std::vector<Finding>& findings);

}  // namespace morphe::planning
