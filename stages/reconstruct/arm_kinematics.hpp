#pragma once

#include <optional>

#include "core/human/arm.hpp"
#include "core/motion/human_motion.hpp"

namespace morphe::reconstruct {

/// Enforces constant lengths of upper arm and forearm, the medians of the recording. In every frame
/// the three joint centres move as little as necessary (least sum of squares), so that a
/// measurement error is shared between the joints. A bone with an unseen end is left unchanged. The
/// deviations of the bones' lengths are added to `residuals` ("upper arm length", "forearm
/// length"). If they exceed 20 mm RMS, the joints stay unchanged and `reconstruction_notes` gets a
/// sentence. `known` lengths (of a static trial) replace the medians and are always enforced.
void enforce_bone_lengths(HumanMotion& motion, const std::optional<human::ArmLengths>& known = {});

/// Computes `arm_angles` from shoulder, elbow, wrist and the hand's orientation in frames in which
/// all are seen (core/human/arm_angles; the trunk is assumed to face Y). Adds the residuals "arm
/// angles", the error of elbow or wrist caused by the joint limits, and "arm angles, hand", the
/// rotation error of the hand times 0.1 m. `arm_angles` has no rows if all four are never seen
/// together.
void add_arm_angles(HumanMotion& motion);

}  // namespace morphe::reconstruct
