#pragma once

#include "core/motion/plan.hpp"
#include "stages/verify/violation_log.hpp"

namespace morphe::verify {

/// Records `phase` violations for phases that no movement has, and for samples outside their phase:
/// a phase's name   its times or its confidence are invalid; it begins before the previous phase
///                  ends (a preshape: lies outside of the reach before it); the order is not rest,
///                  reach, grasp, transport and hold, return; a second preshape or grasp. Any phase
///                  may be missing, and a hold before the grasp may be followed by another reach;
///                  a lift is not the begin of the first transport, a place not the end of the last
///                  one, a release, retreat or home is outside of its end and that of the return,
///                  or they are not in this order; an approach is among them
/// movement         begins before the first phase, or ends after the last
/// trajectory       samples in a phase other than the one at their demonstration time: one that
///                  refines transport and return, else the shortest
/// Borders have a tolerance of 1e-9 s, within which either side is valid.
void verify_phases(const Plan& plan, ViolationLog& violations);

}  // namespace morphe::verify
