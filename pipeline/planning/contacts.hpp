#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/collision/world.hpp"
#include "pipeline/planning/planner.hpp"
#include "stages/grasp/desired_contact.hpp"

namespace morphe::planning {

/// The desired contacts of a plan.
struct Contacts {
  std::vector<grasp::DesiredContact> contacts;
  std::vector<std::string> notes;  ///< one sentence each, such as a reason without contacts
};

/// A plan whose pads touch the target, and its contacts.
struct ContactPlan {
  Plan plan;
  Contacts contacts;
};

/// Returns the person's contacts with the target, for a plan whose path follows the tips. Requires
/// the config's section `grasp`. If there is a target but no contact, a note has the reason.
Contacts demonstrated_contacts(const PlanningInputs& planner,
                               const collision::CollisionWorld& world, const Plan& by_tips);

/// Plans contacts of the pads with the target (contact_attempt.hpp), where `by_tips` has tips near
/// it. While attempts fail, the request is relaxed (contact_relaxations.hpp). `world` contains the
/// plan's scene and has a target; its tolerances apply. `demonstrated` must not be empty. Refuses
/// with the failure of the first attempt if no contact can be kept.
Outcome<ContactPlan> plan_contacts(const PlanningInputs& planner,
                                   const collision::CollisionWorld& world, std::uint64_t seed,
                                   const std::vector<grasp::DesiredContact>& demonstrated,
                                   const Plan& by_tips);

/// Returns the plan `by_tips`, changed as far as it enters the target deeper than the tolerances of
/// `world` permit. Refuses if the tips cannot be kept out.
Outcome<Plan> plan_without_contacts(const PlanningInputs& planner,
                                    const collision::CollisionWorld& world, std::uint64_t seed,
                                    const Plan& by_tips);

/// Returns "contacts given up (tracking): …" with the failure's detail. If `tips` are named, it
/// begins with "contact of thumb_tip, index_tip".
std::string given_up_sentence(const std::vector<std::string>& tips, const PlanningFailure& failure);

}  // namespace morphe::planning
