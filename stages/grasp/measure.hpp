#pragma once

#include "core/collision/world.hpp"
#include "stages/grasp/desired_contact.hpp"

namespace morphe::grasp {

/// Returns true if a pad at this gap [m] and angle from the surface's normal [rad] touches, by
/// kMaxContactGap_m and kMaxContactAngle_rad.
bool is_touching(double gap_m, double pad_angle_rad);

/// Measures the contacts of posture q at `time_s`: for each desired contact, the signed distance of
/// its pad from the target, and the nearest point of the target's surface with its normal in the
/// target's frame. Returns no contacts if `world` has no target.
std::vector<PadContact> measure_contacts(const collision::CollisionWorld& world,
                                         const std::vector<DesiredContact>& touches,
                                         const JointVector& q, double time_s);

}  // namespace morphe::grasp
