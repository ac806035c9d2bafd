#pragma once

#include "core/motion/demonstration.hpp"
#include "stages/reconstruct/time_grid.hpp"

namespace morphe::reconstruct {

/// Reconstructs arm, hand and two fingertips from marker clusters (a right hand).
HumanMotion motion_from_markers(const Demonstration& demonstration,
                                const ReconstructOptions& options);

/// Reconstructs a motion from tracked bodies and recorded fingertips or a glove (which may be
/// alone), with an estimate of the parts of the arm that were not tracked.
HumanMotion motion_from_sensors(const Demonstration& demonstration,
                                const ReconstructOptions& options, const HumanOptions& human);

/// Reconstructs a skeleton's right arm: shoulder, elbow and wrist; the hand's orientation
/// (hand_orientation); finger joints and tips, bone by bone with constant lengths; hand angles if
/// the hand is complete. Tips that coincide with the joint before them and parts of the arm that
/// were not recorded are estimated.
HumanMotion motion_from_skeleton(const Demonstration& demonstration,
                                 const ReconstructOptions& options, const HumanOptions& human);

/// Reconstructs the hand angles alone, from 21 keypoints of a hand whose wrist was not tracked.
HumanMotion motion_from_hand(const Demonstration& demonstration, const ReconstructOptions& options);

}  // namespace morphe::reconstruct
