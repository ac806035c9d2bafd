#pragma once

#include "stages/reconstruct/reconstruct.hpp"

namespace morphe::reconstruct {

/// The arm that a demonstration is not of, rebuilt from what the recording shows of both sides: a
/// skeleton's joints or the body's markers. Tracked sensors, gloves, keypoints and joint angles are
/// of the recorded hand alone. It lies where a motion of the side `beside` is, which reconstruct()
/// (right) or its mirrored() (left) gives: a left arm beside a right one. Frames may be none.
HumanMotion reconstruct_other_arm(const Demonstration& demonstration,
                                  const ReconstructOptions& options, const HumanOptions& human,
                                  Side beside);

}  // namespace morphe::reconstruct
