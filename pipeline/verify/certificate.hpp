#pragma once

#include "pipeline/motion/plan.hpp"
#include "pipeline/verify/limits.hpp"
#include "pipeline/verify/violation_runs.hpp"

namespace morphe::judge {

/// Notes `certificate` for each attribute of the plan's certificate that does not agree with what
/// was recomputed: position_margin to 1e-6 rad, velocity_ratio, acceleration_ratio, jerk_ratio and
/// tempo to 1e-4 of the value, position_error_max to 1e-4 m, clearance at most 1e-4 m too high.
void judge_certificate(const Plan& plan, const LimitUse& use, double clearance,
                       double position_error_max, ViolationRuns& runs);

}  // namespace morphe::judge
