#pragma once

#include "core/collision/world.hpp"
#include "stages/grasp/touch.hpp"

namespace morphe::grasp {

/// The contacts of a posture: what the capsule of each pad that is to touch is from the target, and
/// where. In the target's frame, where it lies at `time_s`.
std::vector<PadContact> measure_contacts(const collision::CollisionWorld& world,
                                         const std::vector<Touch>& touches, const JointVector& q,
                                         double time_s);

}  // namespace morphe::grasp
