#pragma once

#include "core/motion/plan.hpp"
#include "stages/verify/clearance_by_kind.hpp"
#include "stages/verify/limits.hpp"
#include "stages/verify/violation_log.hpp"

namespace morphe::verify {

/// Recomputes a plan's certificate from its samples, goals and mapped frames, with the `use` that
/// verify_limits() and the `clearance` that verify_contacts() returned. natural_posture_error is
/// not recomputed, because the natural posture is defined in the mapping's config.
Certificate recompute_certificate(const RobotModel& robot, const Plan& plan, const Curve& curve,
                                  const LimitUse& use, const ClearanceByKind& clearance);

/// Records a `certificate` violation for each attribute of the plan's certificate that disagrees
/// with the recomputed value. The tolerance is 1e-4 m for the clearance, which must be NaN if no
/// pair could touch, and for those by kind, which, if there are any, must be there exactly if the
/// kind has such pairs. For all others it is 1e-9 max(1, |value|), for velocity_ratio with braking
/// curves 3e-6 max(1, |value|), for jerk_ratio more by the error that rounding of samples causes.
void verify_certificate(const RobotModel& robot, const Plan& plan, const Curve& curve,
                        const LimitUse& use, const ClearanceByKind& clearance,
                        ViolationLog& violations);

/// Records a `certificate` violation for each value in the certificate of a plan without a
/// trajectory, and a `structure` violation for a grasp, an approach or a retreat of it.
void verify_no_certificate(const Plan& plan, ViolationLog& violations);

}  // namespace morphe::verify
