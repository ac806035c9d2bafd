#pragma once

#include <optional>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "pipeline/explain/advice.hpp"
#include "pipeline/planning/run_config.hpp"

namespace morphe::explain {

/// An advice, and the plan that resulted from it if it was tried.
struct TriedAdvice {
  Advice advice;
  std::optional<Plan> plan;
};

/// Collects the advice for an infeasible plan, in this order:
///   1. a shift of the base by at most 160 mm, if find_base_shift() returns one
///   2. advice_for()
///   3. a narrower target, or no target, if find_oversized_target() returns one
/// Without the run's `config` (nullptr) there is only advice_for(). With config and demonstration,
/// the advice is tried in this order until the movement becomes executable.
std::vector<TriedAdvice> collect_advice(const robot::Robot& robot, const Plan& plan,
                                        const planning::RunConfig* config,
                                        const Demonstration* demonstration);

}  // namespace morphe::explain
