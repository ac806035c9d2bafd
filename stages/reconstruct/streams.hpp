#pragma once

#include "stages/reconstruct/clock.hpp"
#include "stages/reconstruct/reconstruct.hpp"

namespace morphe::reconstruct {

/// A motion of `clock.count` frames in which nothing is seen.
HumanMotion unseen_motion(const Clock& clock);

/// Arm, hand and two fingertips from marker clusters (a right hand).
HumanMotion motion_from_markers(const Demonstration& demonstration,
                                const ReconstructOptions& options);

/// Tracked bodies, recorded fingertips or a glove (which may come alone), and an estimate of what
/// arm was not tracked.
HumanMotion motion_from_sensors(const Demonstration& demonstration,
                                const ReconstructOptions& options, const HumanOptions& human);

/// A skeleton's right arm: shoulder, elbow and wrist; the hand's orientation from its knuckles (of
/// index, middle and little finger; else from the thumb, said in `problems`); what it has of finger
/// joints and tips, bone by bone with constant lengths; hand angles if it has them all. A tip that
/// stands on the joint before it is estimated, and so is what of the arm was not recorded.
HumanMotion motion_from_skeleton(const Demonstration& demonstration,
                                 const ReconstructOptions& options, const HumanOptions& human);

/// A hand of 21 keypoints whose wrist was not tracked: hand angles alone.
HumanMotion motion_from_hand(const Demonstration& demonstration, const ReconstructOptions& options);

}  // namespace morphe::reconstruct
