#pragma once

#include "stages/reconstruct/reconstruct.hpp"

namespace morphe::reconstruct {

/// Reconstructs a motion as reconstruct() does, but gives a recording of the hand alone (keypoints
/// or a glove, no tracked wrist) a wrist at the world's origin and axes, named in `estimated`.
HumanMotion reconstruct_hand(const Demonstration& demonstration, const ReconstructOptions& options,
                             const HumanOptions& human);

/// Transforms a motion to the frame of the hand, for robots without an arm. The wrist is at the
/// origin with identity orientation and the fingers are relative to it. Shoulder and elbow are
/// unseen, and in frames without the wrist's pose the fingers too. Arm angles are removed.
HumanMotion transform_to_hand_frame(HumanMotion motion);

}  // namespace morphe::reconstruct
