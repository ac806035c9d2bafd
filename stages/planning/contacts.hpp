#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/collision/world.hpp"
#include "stages/grasp/touch.hpp"
#include "stages/planning/planner.hpp"

namespace morphe::planning {

/// What a plan with contacts is judged by: pads sink in by grasp.penetration at most.
Tolerances with_contacts(const PipelineConfig& config);

struct Contacts {
  std::vector<grasp::Touch> touches;  ///< that the goals ask for; none: the plan is what it was
  std::vector<std::string> notes;     ///< a sentence each
};

/// Pads on the target instead of tips near it, for a plan whose path follows the tips: its goals
/// become those of pads, the other fingers close, and the path settles beside where it was, clear
/// of the whole scene; where it is nearly free then, it is re-solved firmly. What is still in the
/// way costs the fingers in question their contacts, once; then all. Nothing is searched: goals of
/// pads lie beside those of tips, and so do the paths. `world` is that of plan.scene, with the
/// plan's tolerances.
Contacts touch_target(const Planner& planner, const collision::CollisionWorld& world,
                      std::uint64_t seed, Plan& plan);

/// Tips with contacts that findings speak of: they are away from their goals, or their links
/// collide.
std::vector<std::string> tips_in_the_way(const robot::Robot& robot, const Goals& goals,
                                         const std::vector<Finding>& findings);

/// "contacts given up: tracking, thumb_tip ...", or those of some tips.
std::string given_up_sentence(const std::vector<std::string>& tips, const Refusal& refusal);

}  // namespace morphe::planning
