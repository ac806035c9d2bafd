#pragma once

#include "core/motion/asked.hpp"
#include "stages/verify/limits.hpp"

namespace morphe::verify {

/// An approach, at the end of which the trajectory begins, or a retreat, which begins at its end.
enum class Transfer { approach, retreat };

/// So far an end of it may be off what it meets [rad, m]: five times what a path's end is inside of
/// a joint's limit, and what the export joins.
constexpr double kTransferEnd = 1e-6;

/// Notes `transfer` for what such a motion promises beside limits and contacts:
/// demonstration_time  another than that of the trajectory's end that it meets: the clock stands
///                     still, or touching would be allowed meanwhile; 1e-9 s
/// phase               another than rest
/// home                its other end is off the posture that was asked for, kTransferEnd
void judge_transfer(const Plan& plan, const Trajectory& motion, Transfer which, const Asked* asked,
                    ViolationRuns& runs);

/// Notes `config` where a motion uses more of velocity, acceleration or jerk than was asked for.
void judge_share(const LimitUse& use, double share, ViolationRuns& runs);

}  // namespace morphe::verify
