#pragma once

#include "core/motion/plan_request.hpp"
#include "stages/verify/limits.hpp"

namespace morphe::verify {

/// The two motions beside the trajectory: the approach ends at the trajectory's first sample, and
/// the retreat begins at its last one.
enum class ApproachOrRetreat { approach, retreat };

/// Tolerance of a junction between two motions [rad, m]: five times the margin by which a path's
/// end stays inside a joint limit, and the tolerance within which the export joins motions.
constexpr double kJunctionTolerance = 1e-6;

/// Records `transfer` violations of the requirements on an approach or retreat that go beyond
/// limits and contacts:
/// demonstration_time  differs from that of the trajectory's end that the motion meets by more than
///                     1e-9 s: the demonstration clock must stand still, or contact would be
///                     allowed during the motion
/// phase               differs from rest
/// home                the motion's other end deviates from the requested posture by more than
///                     kJunctionTolerance
void verify_approach_retreat(const Plan& plan, const Trajectory& motion, ApproachOrRetreat which,
                             const PlanRequest* asked, ViolationCollector& runs);

/// Records `config` violations if a motion uses a larger share of the velocity, acceleration or
/// jerk limits than was requested.
void verify_limit_scaling(const LimitUse& use, double share, ViolationCollector& runs);

}  // namespace morphe::verify
