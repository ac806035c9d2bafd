#pragma once

#include "stages/simulate/rollout.hpp"
#include "stages/simulate/simulation.hpp"

namespace morphe::simulate {

/// Executes the task of a plan from the squeezed state on: carries the target, lets go of it and
/// leaves. Sets the rollout's `lift` to the result of holding it until the release, and its `task`.
void execute_task(const PreparedPlan& plan, const SimulateOptions& options, Simulation& simulation,
                  Rollout& rollout);

}  // namespace morphe::simulate
