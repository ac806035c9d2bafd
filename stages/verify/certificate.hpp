#pragma once

#include "core/motion/plan.hpp"
#include "stages/verify/limits.hpp"
#include "stages/verify/violation_runs.hpp"

namespace morphe::verify {

/// A plan's certificate, recomputed from its samples, goals and mapped frames.
/// natural_posture_error is not: what the posture is stands in the mapping's config.
Certificate recomputed_certificate(const RobotTable& robot, const Plan& plan, const Curve& curve,
                                   const LimitUse& use, double clearance);

/// Notes `certificate` for each attribute of the plan's certificate that does not agree with what
/// was recomputed: to 1e-4 m the clearance (NaN where nothing could touch), all others to 1e-9 of
/// 1 or of their value, whichever is more, jerk_ratio also to what rounding of the samples makes.
void judge_certificate(const RobotTable& robot, const Plan& plan, const Curve& curve,
                       const LimitUse& use, double clearance, ViolationRuns& runs);

}  // namespace morphe::verify
