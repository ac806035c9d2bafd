#pragma once

#include <optional>
#include <string>
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

/// Collects the advice for an infeasible plan: another base position if single postures show one
/// within 160 mm, advice_for(), and a narrower target or no target if it was inferred so wide that
/// it obstructs the person's own fingertips (`config` is the run's; nullptr: advice_for() alone).
/// With `demonstration`, the advice is tried in order until the movement becomes executable.
std::vector<TriedAdvice> collect_advice(const robot::Robot& robot, const Plan& plan,
                                        const planning::RunConfig* config,
                                        const Demonstration* demonstration);

}  // namespace morphe::explain
