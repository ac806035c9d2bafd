#pragma once

#include "core/motion/demonstration.hpp"
#include "core/motion/human_motion.hpp"

namespace morphe::reconstruct {

/// Returns the mirror image X -> -X of a left-handed demonstration: the same movement of a right
/// hand. Points are mirrored, orientations become M R M with M = diag(-1, 1, 1), markers of the
/// left side swap their first letter with those of the right, joints of a skeleton their left_ with
/// right_; keypoints, sensor offsets and objects are mirrored too. Joint angles and gloves, being
/// anatomical, are unchanged. `hand` of the result is "right". Applying the function twice gives
/// the original (except for `hand`).
Demonstration mirror_image(const Demonstration& demonstration);

/// Returns the mirror image of a motion, as that of the other arm: for a left robot, of a motion
/// reconstructed as a right arm. z of the hand and of the fingertips still points along the fingers
/// and x out of the palm; y, which points to the thumb of a right hand, points away from that of a
/// left one.
HumanMotion mirror_image(HumanMotion motion);

/// Returns the recorded objects in the world of a motion of that side, mirrored if the other hand
/// moved. Samples in which an object was not seen are removed, as are objects that were never seen.
std::vector<SceneObject> objects_on_side(const Demonstration& demonstration, Side hand);

}  // namespace morphe::reconstruct
