#pragma once

#include "core/motion/human_motion.hpp"
#include "core/motion/outcome.hpp"
#include "stages/reconstruct/reconstruct.hpp"

namespace morphe::reconstruct {

/// Name of the residual of `HumanMotion` that says by how much elbow and wrist lie beyond what
/// human joints can do.
inline constexpr const char* kBeyondLimits = "arm angles";

/// not_human where that is more than `HumanOptions::beyond_limits_m` (RMS over the recording): no
/// person's arm was there, so somebody is turned, mirrored or called otherwise.
Refusal refuse_inhuman(const HumanMotion& motion, const HumanOptions& human);

}  // namespace morphe::reconstruct
