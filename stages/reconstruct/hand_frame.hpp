#pragma once

#include "pipeline/motion/demonstration.hpp"
#include "pipeline/motion/human_motion.hpp"

namespace morphe {

/// A recording of the hand alone (keypoints or a glove, no wrist tracked) with a wrist that stays
/// at the world's origin, its axes the world's, so that it can be rebuilt; any other as it is.
Demonstration with_still_wrist(const Demonstration& demonstration);

/// The motion as seen from the hand: wrist at the origin, its orientation the identity, fingers
/// relative to it; shoulder and elbow are no longer seen. For robots without an arm. Frames in
/// which the wrist's pose was not seen have no fingers either.
HumanMotion in_hand_frame(HumanMotion motion);

}  // namespace morphe
