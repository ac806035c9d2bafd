#pragma once

#include "pipeline/motion/demonstration.hpp"

namespace morphe::reconstruct {

/// A left-handed demonstration seen in the mirror X -> -X: the same movement of a right hand.
/// Points are mirrored, orientations become M R M with M = diag(-1, 1, 1), markers of the left side
/// swap their first letter with those of the right, joints of a skeleton their left_ with right_;
/// keypoints, sensor offsets and objects are mirrored too. Joint angles and gloves, being
/// anatomical, stay. `hand` of the result is "right". Applying it twice gives the original
/// (except for `hand`).
Demonstration mirrored(const Demonstration& demonstration);

/// The recorded objects where the rebuilt motion is: those of a left hand in the mirror.
std::vector<SceneObject> objects_beside_right_hand(const Demonstration& demonstration);

}  // namespace morphe::reconstruct
