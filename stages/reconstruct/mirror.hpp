#pragma once

#include "core/motion/demonstration.hpp"
#include "core/motion/human_motion.hpp"

namespace morphe::reconstruct {

/// A left-handed demonstration seen in the mirror X -> -X: the same movement of a right hand.
/// Points are mirrored, orientations become M R M with M = diag(-1, 1, 1), markers of the left side
/// swap their first letter with those of the right, joints of a skeleton their left_ with right_;
/// keypoints, sensor offsets and objects are mirrored too. Joint angles and gloves, being
/// anatomical, stay. `hand` of the result is "right". Applying it twice gives the original
/// (except for `hand`).
Demonstration mirrored(const Demonstration& demonstration);

/// A motion seen in the mirror, as that of the other arm: what was rebuilt as a right one for a
/// left robot. z of the hand and of the fingertips still points along the fingers and x out of the
/// palm; y, to the thumb of a right hand, points away from that of a left one.
HumanMotion mirrored(HumanMotion motion);

/// The recorded objects where a motion of that side is: in the mirror, if the other hand moved.
/// Without the samples in which an object was not seen; one that never was is left out.
std::vector<SceneObject> objects_beside(const Demonstration& demonstration, Side hand);

}  // namespace morphe::reconstruct
