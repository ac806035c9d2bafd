#include "stages/grasp/carrying.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "core/closure/opposed_contacts.hpp"
#include "stages/grasp/constants.hpp"

namespace morphe::grasp {
namespace {

/// Returns "index_tip is near it (gap 1.6 mm, pad 76 degrees off)" or the like.
std::string contact_text(const PadContact& contact) {
  if (contact.state == ContactState::touching) return contact.tip + " touches it";
  return fmt::format("{} is near it (gap {:.1f} mm, pad {:.0f} degrees off)", contact.tip,
                     1e3 * contact.signed_distance, contact.pad_angle / kRadPerDegree);
}

std::string contacts_text(const std::vector<PadContact>& contacts) {
  std::string text;
  for (const PadContact& contact : contacts)
    text += (text.empty() ? "" : ", ") + contact_text(contact);
  return text.empty() ? "no pad touches it" : text;
}

std::size_t fingers_with_pads(const robot::Robot& robot) {
  std::set<int> fingers;
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip)
    if (robot.pads[tip].capsule >= 0) fingers.insert(robot.tips[tip].finger);
  return fingers.size();
}

}  // namespace

bool must_be_held(const robot::Robot& robot, const Movement& movement) {
  return !std::isnan(carrying_begin_s(movement)) && fingers_with_pads(robot) > 1;
}

bool is_held(const Grasp& grasp) {
  closure::ContactSet touching;
  touching.friction.mu = grasp.quality.friction_coefficient;
  for (const PadContact& contact : grasp.contacts) {
    if (contact.state == ContactState::touching)
      touching.contacts.push_back({contact.point, contact.normal});
  }
  return closure::has_opposed_contacts(touching) || grasp.quality.epsilon_lower > 0;
}

PlanningFailure check_held(const robot::Robot& robot, const Plan& plan) {
  if (!must_be_held(robot, plan.movement)) return {};
  if (!is_held(plan.grasp)) {
    return {Reason::not_held, fmt::format("{} is carried from {:.2f} s on without two opposed "
                                          "contacts: {}",
                                          plan.movement.target, carrying_begin_s(plan.movement),
                                          contacts_text(plan.grasp.contacts))};
  }
  const Certificate& c = plan.certificate;
  if (c.held_drift <= kMaxHeldDrift_m && c.held_turn <= kMaxHeldTurn_rad) return {};
  return {Reason::not_held,
          fmt::format("the pads that hold {} move by {:.2f} mm and turn by {:.2f} degrees in the "
                      "hand until the release; allowed: {:.1f} mm, {:.0f} degree",
                      plan.movement.target, 1e3 * c.held_drift, c.held_turn / kRadPerDegree,
                      1e3 * kMaxHeldDrift_m, kMaxHeldTurn_rad / kRadPerDegree)};
}

}  // namespace morphe::grasp
