#pragma once

#include "core/motion/plan.hpp"
#include "stages/verify/limits.hpp"
#include "stages/verify/violation_collector.hpp"

namespace morphe::verify {

/// Recomputes a plan's certificate from its samples, goals and mapped frames. The field
/// natural_posture_error is not recomputed, because the natural posture is defined in the mapping's
/// config.
Certificate recompute_certificate(const RobotModel& robot, const Plan& plan, const Curve& curve,
                                  const LimitUse& use, double clearance);

/// Records `certificate` violations for each attribute of the plan's certificate that disagrees
/// with the recomputed value. The tolerance is 1e-4 m for the clearance (NaN if no pair could
/// touch) and 1e-9 of the larger of 1 and the value for all others; jerk_ratio is also allowed the
/// error that rounding of the samples causes.
void verify_certificate(const RobotModel& robot, const Plan& plan, const Curve& curve,
                        const LimitUse& use, double clearance, ViolationCollector& runs);

}  // namespace morphe::verify
