#pragma once

#include <optional>

#include "core/human/arm.hpp"
#include "core/motion/human_motion.hpp"

namespace morphe::reconstruct {

/// Enforces constant lengths of upper arm and forearm: the `known` ones, otherwise the medians of
/// the recording. In every frame the joint centres move as little as necessary (least sum of
/// squares); a bone with an unseen end is left unchanged. The deviations of the recorded lengths
/// are added to `residuals` ("upper arm length", "forearm length"). If the lengths are medians and
/// a deviation exceeds 20 mm RMS, no joint moves and `reconstruction_notes` gets a sentence.
void enforce_bone_lengths(HumanMotion& motion, const std::optional<human::ArmLengths>& known = {});

/// Computes `arm_angles` in frames in which shoulder, elbow, wrist and the hand's orientation are
/// seen (core/human/arm_angles; the trunk is assumed to face Y); no rows if there is no such frame.
/// Adds two residuals, the errors that human joint limits leave: "arm angles", the larger of the
/// errors of elbow and wrist, and "arm angles, hand", the rotation error of the hand times 0.1 m.
/// `reconstruction_notes` gets a sentence for each above 20 mm or 0.3 rad RMS.
void add_arm_angles(HumanMotion& motion);

}  // namespace morphe::reconstruct
