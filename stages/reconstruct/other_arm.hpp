#pragma once

#include "stages/reconstruct/reconstruct.hpp"

namespace morphe::reconstruct {

/// Reconstructs the arm that is not the demonstrated one from streams that show both sides: a
/// skeleton's joints or the body's markers. Tracked sensors, gloves, keypoints and joint angles
/// belong to the demonstrated hand alone. The result is in the world of a motion of the side
/// `beside`, as given by reconstruct() (right) or its mirror_image() (left): a left arm beside a
/// right one. It may have no frames.
HumanMotion reconstruct_other_arm(const Demonstration& demonstration,
                                  const ReconstructOptions& options, const HumanOptions& human,
                                  Side beside);

}  // namespace morphe::reconstruct
