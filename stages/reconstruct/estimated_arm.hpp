#pragma once

#include <optional>

#include "core/human/arm.hpp"
#include "stages/reconstruct/reconstruct.hpp"

namespace morphe::reconstruct {

/// Returns the lengths of upper arm and forearm: the recording's own, otherwise the config's,
/// otherwise those for a stature. The stature is the config's, otherwise that of a person with a
/// hand of the given length (wrist to middle fingertip [m]; 0.108 of the stature, Drillis and
/// Contini 1966), otherwise 1.70 m.
human::ArmLengths arm_lengths_of(const Demonstration& demonstration, const HumanOptions& human,
                                 const std::optional<double>& hand_length = {});

/// Estimates the parts of a right arm that were never seen, from the wrist and perhaps the head [N]
/// in the world (the person faces Y). The estimated joints are named in `estimated`:
///   shoulder  a fixed position for the whole recording: below and beside the head if that was
///             seen, by shares of the stature (0.115 below, 0.129 - 0.02 aside: half of the
///             biacromial breadth less the joint's depth); otherwise `shoulder_from_first_wrist`
///             from the first wrist; then moved as little as necessary to reach every wrist
///   elbow     on the circle determined by the lengths, at the swivel angle `elbow_swivel` (a
///             swivel angle optimised for the hand's orientation within human limits is no nearer
///             to the person's)
/// If they are hidden in the five ue-adl trials, shoulders are estimated within 48 to 65 mm RMS,
/// elbows of reaches within 51 and 62 mm, and elbows of drinking, in which they are lifted, within
/// 120 to 181 mm; the direction of the upper arm is off by 5 and 9 degrees, or 19 to 32.
void estimate_arm(const human::ArmLengths& lengths, const HumanOptions& human,
                  const std::vector<Vec3>& head, HumanMotion& motion);

}  // namespace morphe::reconstruct
