#pragma once

#include <optional>

#include "core/human/arm.hpp"
#include "core/motion/human_motion.hpp"

namespace morphe::reconstruct {

/// Gives upper arm and forearm one length each, the median of the recording's. In every frame the
/// three joint centres move as little as that takes (least sum of squares): a measurement error is
/// shared between the joints. A bone with an unseen end is left. What the bones' lengths were off
/// by goes into `residuals` ("upper arm length", "forearm length"). Where that is more than 20 mm
/// RMS nothing moves, and `problems` says so. Lengths that are `known` (of a static trial) hold in
/// place of the medians, whatever the recording says.
void keep_bone_lengths(HumanMotion& motion, const std::optional<human::ArmLengths>& known = {});

/// Fills `arm_angles` from shoulder, elbow, wrist and the hand's orientation, where all are seen
/// (core/human/arm_angles; the trunk is taken to face Y). Residuals: "arm angles", what elbow
/// or wrist are missed by for the limits' sake, and "arm angles, hand", the rotation that the hand
/// is missed by times 0.1 m. No rows if no frame has them all.
void add_arm_angles(HumanMotion& motion);

}  // namespace morphe::reconstruct
