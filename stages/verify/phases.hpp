#pragma once

#include "core/motion/plan.hpp"
#include "stages/verify/violation_collector.hpp"

namespace morphe::verify {

/// Records `phase` violations for phases that no movement has, and for samples outside their phase:
/// a phase's name   its times or its confidence are invalid; it begins before the previous phase
///                  ends (preshape: is outside of the reach before it); the order is not reach,
///                  grasp, transport and hold, return, with at most one preshape and one grasp
/// movement         begins before the first phase, or ends after the last
/// trajectory       samples in a phase other than the shortest one that contains their
///                  demonstration time
/// Borders have a tolerance of 1e-9 s, within which either side is valid.
void verify_phases(const Plan& plan, ViolationCollector& runs);

}  // namespace morphe::verify
