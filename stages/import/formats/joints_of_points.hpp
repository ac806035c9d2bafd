#pragma once

#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// Points that are called as joints (right_shoulder, left_index_tip, …) are joints, not markers on
/// the skin: they leave the markers for a skeleton without parents and orientations. All 21 points
/// of the recorded hand without an arm become keypoints instead where the wrist or the middle of
/// the hand is at rest throughout: those have no place. Said in `reports`.
void take_joints(Side hand, Demonstration& demonstration);

}  // namespace morphe::imports
