#pragma once

#include "stages/reconstruct/reconstruct.hpp"

namespace morphe::reconstruct {

/// As reconstruct(); but a recording of the hand alone (keypoints or a glove, no wrist tracked) has
/// a wrist that stays at the world's origin, its axes the world's: `estimated` names it.
HumanMotion reconstruct_hand(const Demonstration& demonstration, const ReconstructOptions& options,
                             const HumanOptions& human);

/// The motion as seen from the hand: wrist at the origin, its orientation the identity, fingers
/// relative to it; shoulder and elbow are no longer seen. For robots without an arm. Frames in
/// which the wrist's pose was not seen have no fingers either.
HumanMotion in_hand_frame(HumanMotion motion);

}  // namespace morphe::reconstruct
