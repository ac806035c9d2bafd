#pragma once

#include <vector>

#include "pipeline/setup/find_hand.hpp"

namespace morphe::setup {

/// Takes chains out of `fingers` that cannot be fingers, and returns them with the reason. Except
/// for the first one, a reason counts only if it leaves other chains:
///   - no extent: no body, and joints at the palm's origin only
///   - joints that turn freely (a propeller, a wheel, a gear): a finger's have ends
///   - no body: neither shapes nor a mass nor a tip, where others have one of them
///   - an end that comes near to no other one in any of the sampled postures.
///     This needs the shapes of all chains.
std::vector<LeftOut> leave_out_idle_chains(const Kinematics& robot, int root,
                                           const BodyPoints& points, std::vector<Finger>& fingers);

}  // namespace morphe::setup
