#pragma once

#include <string>

#include "core/motion/plan.hpp"

namespace morphe::certify {

/// Returns the reasons for which a trajectory with this certificate is approximate and not
/// executable, or "". It is approximate if
///   - the share of its fingertip goals that are out of reach exceeds max_unreachable_share
///   - a tip is farther from its goal than max_tip_error, in any phase
///   - the share of missing goals of a phase exceeds max_missing_goal_share
///   - for longer than max_goal_gap_s there is no goal
std::string approximate_reason(const Goals& goals, const Movement& movement,
                               const Tolerances& tolerances, const Certificate& certificate);

}  // namespace morphe::certify
