#pragma once

#include <string>

#include "core/motion/plan.hpp"

namespace morphe::certify {

/// Why a trajectory with this certificate is approximate and not executable, "" if it is not: more
/// of its goals are out of reach than out_of_reach_share, or a tip is farther than farthest_tip
/// from its goal, whatever `tracking` allows.
std::string only_near(const Goals& goals, const Tolerances& tolerances,
                      const Certificate& certificate);

}  // namespace morphe::certify
