#include "stages/grasp/carrying.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "core/closure/opposed_contacts.hpp"

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

double carrying_begin_s(const Movement& movement) {
  if (movement.target.empty()) return kUnknown;
  for (const Phase& phase : movement.phases) {
    if (phase.kind == PhaseKind::transport && phase.begin_s < movement.end_s) return phase.begin_s;
  }
  return kUnknown;
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

PlanningFailure check_held(const robot::Robot& robot, const Movement& movement,
                           const Grasp& grasp) {
  const double begin_s = carrying_begin_s(movement);
  if (std::isnan(begin_s) || fingers_with_pads(robot) < 2 || is_held(grasp)) return {};
  return {Reason::not_held,
          fmt::format("{} is carried from {:.2f} s on without two opposed contacts: {}",
                      movement.target, begin_s, contacts_text(grasp.contacts))};
}

}  // namespace morphe::grasp
