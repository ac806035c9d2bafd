#pragma once

#include "stages/reconstruct/reconstruct.hpp"

namespace morphe::reconstruct {

/// Reconstructs a motion as reconstruct() does, except that a recording of the hand alone
/// (keypoints or a glove, no tracked wrist) gets a wrist fixed at the world's origin, with the
/// world's axes, and named in `estimated`.
HumanMotion reconstruct_hand(const Demonstration& demonstration, const ReconstructOptions& options,
                             const HumanOptions& human);

/// Transforms a motion to the frame of the hand: the wrist is at the origin with the identity as
/// its orientation, the fingers are relative to it, and shoulder and elbow are unseen. It is meant
/// for robots without an arm. Frames in which the wrist's pose was not seen have no fingers either.
HumanMotion transform_to_hand_frame(HumanMotion motion);

}  // namespace morphe::reconstruct
