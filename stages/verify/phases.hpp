#pragma once

#include "core/motion/plan.hpp"
#include "stages/verify/violation_runs.hpp"

namespace morphe::verify {

/// Notes `phase` for phases that no movement has, and samples that are not in theirs:
/// a phase's name   its times or confidence are no such; it begins before the one before it ends
///                  (preshape: lies outside of the reach before it); the order is not reach, grasp,
///                  transport and hold, return, with one preshape and one grasp at most
/// movement         begins before the first phase, or ends after the last
/// trajectory       samples in a phase other than the shortest that holds their demonstration time
/// Borders count to 1e-9 s, so that either side of one is good.
void judge_phases(const Plan& plan, ViolationRuns& runs);

}  // namespace morphe::verify
