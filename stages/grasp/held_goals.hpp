#pragma once

#include "stages/grasp/desired_contact.hpp"

namespace morphe::grasp {

/// Returns true if the hand keeps still on the target at a time: from closed_s to opening_s.
bool is_held_at(const HoldInterval& hold, double time_s);

/// Sets the goals of the tips without a contact, as of a hand that holds the target as one rigid
/// body. While it is held, the goal of a tip x is
///   base_from_target(t) base_from_target(g)⁻¹ x(q),
/// with the posture q [n] of the hand at the time g of the frame `grasp_frame`. The goals of tips
/// that were recorded are blended from the recorded ones to these and back by closing_progress().
/// Those of the others end with the release, and count as goals that close a finger
/// (Goals::auto_closed). The goals of contacts, set_pad_goals() and set_closure_goals(), follow the
/// target as well.
void set_held_goals(const robot::Robot& robot, const std::vector<DesiredContact>& contacts,
                    const JointVector& q, std::size_t grasp_frame, const Movement& movement,
                    const SceneObject& target, Goals& goals);

}  // namespace morphe::grasp
