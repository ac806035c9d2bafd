#pragma once

#include "core/collision/world.hpp"
#include "stages/grasp/desired_contact.hpp"

namespace morphe::grasp {

/// Measures the contacts of a posture: the distance from the capsule of each desired contact's pad
/// to the target and the contact point, in the frame of the target at its pose at `time_s`.
std::vector<PadContact> measure_contacts(const collision::CollisionWorld& world,
                                         const std::vector<DesiredContact>& touches,
                                         const JointVector& q, double time_s);

}  // namespace morphe::grasp
