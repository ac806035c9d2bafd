#include "pipeline/planning/contacts.hpp"

#include <fmt/format.h>

#include <utility>

#include "pipeline/planning/contact_attempt.hpp"
#include "pipeline/planning/contact_relaxations.hpp"
#include "stages/check/check_path.hpp"
#include "stages/grasp/demonstrated_contacts.hpp"

namespace morphe::planning {
namespace {

/// The last attempt of a search, with its request.
struct ContactSearch {
  ContactAttempt attempt;
  ContactRequest request;
  PlanningFailure first_failure;  ///< of the first attempt
};

/// Requests all demonstrated contacts, then relaxes while attempts fail and a relaxation applies.
ContactSearch search_contacts(const ContactContext& context, const Plan& by_tips) {
  ContactSearch search;
  search.request.contacts = context.demonstrated;
  search.attempt = try_contacts(context, search.request, by_tips);
  search.first_failure = search.attempt.failure;
  while (search.attempt.failure) {
    std::optional<ContactRequest> relaxed = relax_contacts(context, search.attempt, search.request);
    if (!relaxed) break;
    search.request = std::move(*relaxed);
    search.attempt = try_contacts(context, search.request, by_tips);
  }
  return search;
}

}  // namespace

Contacts demonstrated_contacts(const PlanningInputs& planner,
                               const collision::CollisionWorld& world, const Plan& by_tips) {
  const grasp::GraspOptions& options = *planner.config.grasp;
  if (world.target < 0) return {};
  if (planner.config.map.mode == map::MapMode::joint_to_joint) {
    return {{}, {"no contacts: joint-to-joint mapping does not track the tips"}};
  }
  const collision::Solid target = collision::solid_at(world, world.target);
  Contacts found{
      grasp::demonstrated_contacts(planner.robot, by_tips.goals, by_tips.movement, target, options),
      {}};
  grasp::separate_contacts(planner.robot, target, world.tolerances.required_clearance,
                           found.contacts);
  if (found.contacts.empty()) {
    found.notes = {fmt::format(
        "no contacts: no fingertip's skin was within {:.0f} mm of {} for {:.0f} % "
        "of the grasp",
        1e3 * options.touch_distance_m, target.object.name, 100 * options.min_contact_share)};
  }
  return found;
}

Outcome<ContactPlan> plan_contacts(const PlanningInputs& planner,
                                   const collision::CollisionWorld& world, std::uint64_t seed,
                                   const std::vector<grasp::DesiredContact>& demonstrated,
                                   const Plan& by_tips) {
  const SceneObject& target = by_tips.scene.objects[world.target];
  auto [attempt, request, first_failure] =
      search_contacts({planner, world, target, seed, demonstrated}, by_tips);
  if (attempt.failure) return {{by_tips, {}}, first_failure};
  std::vector<std::string> notes = std::move(attempt.notes);
  if (!request.moved.empty()) {
    notes.push_back(fmt::format("contact of {} moved along the surface of {}",
                                fmt::join(request.moved, ", "), target.name));
  }
  if (!request.given_up.empty())
    notes.push_back(given_up_sentence(request.given_up, first_failure));
  return {{std::move(attempt.plan), {std::move(attempt.contacts), std::move(notes)}}, {}};
}

Outcome<Plan> plan_without_contacts(const PlanningInputs& planner,
                                    const collision::CollisionWorld& world, std::uint64_t seed,
                                    const Plan& by_tips) {
  if (world.target < 0) return {by_tips, {}};
  Plan plan = by_tips;
  plan.remaining_findings =
      check::check_path(world, plan.goals, plan.movement, plan.path, planner.config.check);
  if (plan.remaining_findings.empty()) return {std::move(plan), {}};
  const SceneObject& target = plan.scene.objects[world.target];
  ContactAttempt attempt = search_contacts({planner, world, target, seed, {}}, plan).attempt;
  PlanningFailure& failure = attempt.failure;
  if (failure) {
    failure.detail += fmt::format(
        "; the tips' goals are deeper in {} than pads and links may "
        "penetrate",
        target.name);
  }
  return {std::move(attempt.plan), std::move(failure)};
}

std::string given_up_sentence(const std::vector<std::string>& tips,
                              const PlanningFailure& failure) {
  return fmt::format(
      "{} given up ({}): {}",
      tips.empty() ? "contacts" : fmt::format("contact of {}", fmt::join(tips, ", ")),
      name_of(failure.reason), failure.detail);
}

}  // namespace morphe::planning
