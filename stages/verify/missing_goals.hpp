#pragma once

#include "core/motion/plan.hpp"

namespace morphe::verify {

/// The largest share of missing goals of a phase, and the longest time without any goal [s], of the
/// tips that have a goal of the person in some frame. Reach and preshape are one phase, as are
/// grasp and hold, and the time outside of all phases.
struct GoalGaps {
  double largest_share = 0, longest_s = 0;
};
/// Finds the gaps in the goals of a plan.
GoalGaps find_goal_gaps(const Plan& plan);

}  // namespace morphe::verify
