#pragma once

#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// Moves markers that are named as joints (right_shoulder, left_index_tip, …), and so are not on
/// the skin, to a skeleton without parents and orientations. If they are exactly the 21 points of
/// the recorded hand, and its wrist or centre stays within 5 cm, they are in the frame of the hand
/// and become keypoints instead. Both are noted in `import_notes`. The markers must exist.
void extract_joints(Side hand, Demonstration& demonstration);

}  // namespace morphe::imports
