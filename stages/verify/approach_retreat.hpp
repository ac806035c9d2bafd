#pragma once

#include "core/motion/plan_request.hpp"
#include "stages/verify/limits.hpp"

namespace morphe::verify {

/// The two trajectories beside a plan's own: the approach ends at the first sample of that
/// trajectory, and the retreat begins at its last one.
enum class ApproachOrRetreat { approach, retreat };

/// Tolerance of the junction between an approach or a retreat and the trajectory [rad, m]. It is
/// five times the margin by which a path's end stays inside a joint limit. The export joins
/// trajectories within the same tolerance.
constexpr double kJunctionTolerance = 1e-6;

/// Records `approach_retreat` violations of an approach or a retreat, in addition to those of its
/// limits and contacts:
/// demonstration_time  a sample's differs by more than 1e-9 s from that of the trajectory at the
///                     junction. It must stand still, or contact would be allowed on the way
/// phase               a sample's is not rest
/// home                the end away from the junction deviates by more than kJunctionTolerance from
///                     the request's posture; not checked without one
void verify_approach_retreat(const Plan& plan, const Trajectory& motion, ApproachOrRetreat kind,
                             const PlanRequest* request, ViolationLog& violations);

/// Records `config` violations if velocity, acceleration or jerk use more of the robot's limits
/// than the requested share `limit_scaling`.
void verify_limit_scaling(const LimitUse& use, double limit_scaling, ViolationLog& violations);

}  // namespace morphe::verify
