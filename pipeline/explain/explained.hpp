#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "pipeline/explain/advice.hpp"
#include "pipeline/planning/run_config.hpp"

namespace morphe::explain {

/// An advice, and what planning with it gave, if it was tried.
struct TriedAdvice {
  Advice advice;
  std::optional<Plan> plan;
};

/// What to try for an infeasible plan: another place for the base if single postures show one
/// within 160 mm, advice_for(), and a narrower target or none if it was inferred so wide that it is
/// in the way of the person's own fingertips (`config`: the run's; none: advice_for() alone). With
/// `demonstration` each is planned, in order, until one makes the movement executable.
std::vector<TriedAdvice> explained_advice(const robot::Robot& robot, const Plan& plan,
                                          const planning::RunConfig* config,
                                          const Demonstration* demonstration);

}  // namespace morphe::explain
