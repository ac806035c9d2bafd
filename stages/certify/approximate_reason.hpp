#pragma once

#include <string>

#include "core/motion/plan.hpp"

namespace morphe::certify {

/// Returns the reason for which a trajectory with this certificate is approximate and not
/// executable, or "". It is approximate if the share of its fingertip goals that are out of reach
/// exceeds max_unreachable_share, or if a tip is farther from its goal than max_tip_error in any
/// phase.
std::string approximate_reason(const Goals& goals, const Tolerances& tolerances,
                               const Certificate& certificate);

}  // namespace morphe::certify
