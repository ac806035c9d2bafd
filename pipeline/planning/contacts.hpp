#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/collision/world.hpp"
#include "pipeline/planning/planner.hpp"
#include "stages/grasp/desired_contact.hpp"

namespace morphe::planning {

/// The desired contacts of a plan, and notes about them.
struct Contacts {
  std::vector<grasp::DesiredContact> contacts;
  std::vector<std::string> notes;  ///< one sentence each
};

/// Returns the contacts of the person with the target of a plan whose path follows the tips; if
/// there are none although there is a target, the notes contain the reason.
Contacts desired_contacts(const PlanningInputs& planner, const collision::CollisionWorld& world,
                          const Plan& plan);

/// Plans contacts of the pads with the target instead of tips near it. The goals become those of
/// the pads, the other fingers close, and the path is optimised locally in the whole scene; if it
/// is nearly free afterwards, it is solved again with high weights. A pad that does not reach its
/// contact point may touch beside it; the goals of tips that obstruct without touching are kept
/// outside of the target; fingers that still obstruct lose their contacts. Without contacts the
/// tips are only kept out of the target, as far as `world` requires it. There is no global search,
/// because the goals of pads are close to those of tips, and so are the paths. `world` is that of
/// plan.scene, with the plan's tolerances. Refuses if no contact could be kept, or the tips cannot
/// be kept out.
PlanningFailure plan_contacts(const PlanningInputs& planner, const collision::CollisionWorld& world,
                              std::uint64_t seed, Contacts& contacts, Plan& plan);

/// Returns true if the findings concern a tip: it is away from its goals, or its own link collides.
bool findings_concern_tip(const robot::Robot& robot, std::size_t tip,
                          const std::vector<Finding>& findings);

/// Returns "contacts given up (tracking): thumb_tip ...", or the same for the contacts of some
/// tips.
std::string given_up_sentence(const std::vector<std::string>& tips, const PlanningFailure& failure);

}  // namespace morphe::planning
