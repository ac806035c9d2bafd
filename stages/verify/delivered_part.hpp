#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/plan_request.hpp"
#include "stages/verify/violation_log.hpp"

namespace morphe::verify {

/// Returns the time at which a plan until a phase must end: at the end of the last phase of that
/// kind, else of transport (for lift and place) or return (for release, retreat and home), else of
/// the grasp; NaN without a grasp. Computed independently of segmentation.
double planned_end_s(const Movement& movement, PhaseKind until);

/// Records `status` violations of a partial plan:
/// delivered_until   it does not end with the last phase of that kind; it may not end there: the
/// kind
///                   never ends a plan (a reach does without a grasp), or the hand holds the target
///                   in the air, unless the request allows it; or the request allows no such plan
/// requested_end_s   is not later than the plan's end
void verify_delivered_part(const Plan& plan, const PlanRequest* request, ViolationLog& violations);

}  // namespace morphe::verify
