#pragma once

#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// Moves points that are named as joints (right_shoulder, left_index_tip, …), which are not markers
/// on the skin, to a skeleton without parents and orientations. If all 21 points of the recorded
/// hand exist without an arm, and the wrist or the centre of the hand is always at rest, they
/// become keypoints instead, since they have no position in the world. This is added to `reports`.
void extract_joints(Side hand, Demonstration& demonstration);

}  // namespace morphe::imports
