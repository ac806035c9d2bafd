#pragma once

#include "core/collision/world.hpp"
#include "stages/grasp/desired_contact.hpp"

namespace morphe::grasp {

/// Measures the contacts of posture q at `time_s`: for each desired contact, the signed distance of
/// its pad from the target, and the nearest point of the target's surface with its normal in the
/// target's frame. Returns no contacts if `world` has no target.
std::vector<PadContact> measure_contacts(const collision::CollisionWorld& world,
                                         const std::vector<DesiredContact>& touches,
                                         const JointVector& q, double time_s);

}  // namespace morphe::grasp
