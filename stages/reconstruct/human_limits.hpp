#pragma once

#include "core/motion/human_motion.hpp"
#include "core/motion/outcome.hpp"
#include "stages/reconstruct/reconstruct_options.hpp"

namespace morphe::reconstruct {

/// Name of the residual that measures how far [m] elbow or wrist, whichever is farther, were
/// recorded from where an arm within human joint limits can have them (add_arm_angles).
inline constexpr const char* kLimitViolationResidual = "arm angles";

/// Fails with implausible_arm if the RMS of that residual exceeds max_limit_violation_m: no human
/// arm has these poses, so the person is rotated or mirrored, or joints have wrong names. A motion
/// without the residual does not fail.
PlanningFailure check_human_limits(const HumanMotion& motion, const HumanOptions& human);

}  // namespace morphe::reconstruct
