#pragma once

#include <optional>

#include "pipeline/planning/contact_attempt.hpp"

namespace morphe::planning {

/// Returns the next request after a failed attempt, by the first of these relaxations that applies;
/// nullopt if they do not apply. A tip is at fault if a finding names it or the link of its pad.
///   move          If no body collides, the contacts of tips that miss their goals move to the
///                 target's surface beside their pads at the grasp: by at most grasp::kMaxSlide_m
///                 from the demonstrated points, and in at most kMaxContactMoves requests.
///   keep outside  The goals of tips that are at fault and have no contact leave the target.
///   give up       Tips that are at fault lose their contacts. One contact must be left.
std::optional<ContactRequest> relax_contacts(const ContactContext& context,
                                             const ContactAttempt& attempt,
                                             const ContactRequest& request);

}  // namespace morphe::planning
