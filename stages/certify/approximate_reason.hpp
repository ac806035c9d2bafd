#pragma once

#include <string>

#include "core/motion/plan.hpp"

namespace morphe::certify {

/// Returns the reason for which a trajectory with this certificate is approximate and not
/// executable: a larger share of its goals than max_unreachable_share is out of reach, or a tip is
/// farther from its goal than max_tip_error, regardless of `tracking`. Returns "" if it is
/// executable.
std::string approximate_reason(const Goals& goals, const Tolerances& tolerances,
                               const Certificate& certificate);

}  // namespace morphe::certify
