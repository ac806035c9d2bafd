#pragma once

#include "core/motion/demonstration.hpp"
#include "core/motion/outcome.hpp"
#include "core/motion/plan.hpp"

namespace morphe::planning {

/// A plan that says no more than what it is of.
Plan begin_plan(const Demonstration& demonstration, const Movement& movement,
                const Tolerances& tolerances);

/// The plan, given up: its reason and no trajectory.
Plan fail(Plan plan, Refusal refusal);

}  // namespace morphe::planning
