#pragma once

#include "core/motion/demonstration.hpp"
#include "core/motion/human_motion.hpp"

namespace morphe::reconstruct {

/// Returns the mirror image X -> -X of a left-handed demonstration: the same movement of a right
/// hand, with `hand` set to it. Points, objects and sensor offsets are mirrored, orientations
/// become M R M with M = diag(-1, 1, 1), and markers swap L and R at the beginning of their names,
/// joints of a skeleton left_ and right_. Joint angles and gloves, being anatomical, are unchanged.
/// Applying the function twice gives the original (except for `hand`).
Demonstration mirror_image(const Demonstration& demonstration);

/// Returns the mirror image of a motion, as that of the other arm: for a left robot, of a motion
/// reconstructed as a right arm. z of hand and fingertips still points along the fingers and x out
/// of the palm; y, which points to the thumb of a right hand, points away from a left one's.
HumanMotion mirror_image(HumanMotion motion);

/// Returns the recorded objects in the world of a motion of side `hand`, mirrored if the other hand
/// moved, without samples in which they were not seen and objects that never were.
std::vector<SceneObject> objects_on_side(const Demonstration& demonstration, Side hand);

}  // namespace morphe::reconstruct
