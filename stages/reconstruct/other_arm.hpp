#pragma once

#include "stages/reconstruct/reconstruct.hpp"

namespace morphe::reconstruct {

/// Reconstructs the arm that is not the demonstrated one from a skeleton's joints or the body's
/// markers; without these the motion has no frames. The result is in the same world as the
/// demonstrated arm's motion: that of reconstruct() if `side` is right, of its mirror_image() if
/// left.
HumanMotion reconstruct_other_arm(const Demonstration& demonstration,
                                  const ReconstructOptions& options, const HumanOptions& human,
                                  Side side);

}  // namespace morphe::reconstruct
