#pragma once

#include "core/motion/human_motion.hpp"
#include "core/motion/outcome.hpp"
#include "stages/reconstruct/reconstruct.hpp"

namespace morphe::reconstruct {

/// Name of the residual of `HumanMotion` for the distance of elbow and wrist from the range of
/// human joints.
inline constexpr const char* kLimitViolationResidual = "arm angles";

/// Fails with not_human if that residual exceeds `HumanOptions::max_limit_violation_m` (RMS over
/// the recording): no human arm can have these poses, so the person is rotated or mirrored, or
/// joints have wrong names.
PlanningFailure check_human_limits(const HumanMotion& motion, const HumanOptions& human);

}  // namespace morphe::reconstruct
