#pragma once

#include "stages/reconstruct/clock.hpp"
#include "stages/reconstruct/reconstruct.hpp"

namespace morphe {

/// A motion of `clock.count` frames in which nothing is seen.
HumanMotion unseen_motion(const Clock& clock);

/// Arm, hand and two fingertips from marker clusters (a right hand).
HumanMotion motion_from_markers(const Demonstration& demonstration,
                                const ReconstructOptions& options);

/// Tracked bodies, recorded fingertips or a glove (which may come alone), and an estimate of what
/// arm was not tracked.
HumanMotion motion_from_sensors(const Demonstration& demonstration,
                                const ReconstructOptions& options, const HumanOptions& human);

}  // namespace morphe
