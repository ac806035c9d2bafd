#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/collision/world.hpp"
#include "pipeline/planning/planner.hpp"
#include "stages/grasp/touch.hpp"

namespace morphe::planning {

struct Contacts {
  std::vector<grasp::Touch> touches;
  std::vector<std::string> notes;  ///< a sentence each
};

/// Where the person touched the target of a plan whose path follows the tips; none: the notes say
/// why, if there is a target.
Contacts wanted_contacts(const Planner& planner, const collision::CollisionWorld& world,
                         const Plan& plan);

/// Pads on the target instead of tips near it: the goals become those of pads, the other fingers
/// close, and the path settles beside where it was, clear of the whole scene; where it is nearly
/// free then, it is re-solved firmly. A pad that does not come to its place touches beside it; the
/// goals of tips that are in the way without touching are kept out of the target; what is in the
/// way still costs the fingers in question their contacts. Without contacts the tips only keep out
/// of the target, as far as `world` asks for it. Nothing is searched: goals of pads lie beside
/// those of tips, and so do the paths. `world` is that of plan.scene, with the plan's tolerances.
/// Refused: no contact could be kept, or the tips cannot keep out.
Refusal touch_target(const Planner& planner, const collision::CollisionWorld& world,
                     std::uint64_t seed, Contacts& contacts, Plan& plan);

/// Whether findings speak of a tip: it is away from its goals, or its own link collides.
bool in_the_way(const robot::Robot& robot, std::size_t tip, const std::vector<Finding>& findings);

/// "contacts given up: tracking, thumb_tip ...", or those of some tips.
std::string given_up_sentence(const std::vector<std::string>& tips, const Refusal& refusal);

}  // namespace morphe::planning
