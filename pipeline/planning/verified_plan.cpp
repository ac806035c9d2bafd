#include "pipeline/planning/verified_plan.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "core/motion/count_with_noun.hpp"
#include "core/motion/input_error.hpp"
#include "pipeline/planning/begin_plan.hpp"
#include "pipeline/planning/plan_branch.hpp"
#include "pipeline/planning/plan_requirements.hpp"
#include "stages/verify/verify.hpp"

namespace morphe::planning {
namespace {

PlanningFailure failure_of(const std::vector<verify::Violation>& violations) {
  return {Reason::rejected,
          fmt::format("{} in verification, which is a fault of Morphe (please report it): {}",
                      count_with_noun(violations.size(), "violation"),
                      verify::violation_text(violations.front()))};
}

}  // namespace

PlanRequirements requirements_of(const LoadedConfig& config) {
  const PlanFileHeader header = header_of(config, "");
  PlanRequirements requirements{header.config, std::nullopt};
  try {
    requirements.request = plan_requirements(header);
  } catch (const InputError&) {  // `verify` reports it for the file as a whole
  }
  return requirements;
}

Plan verified(const PlanningInputs& planner, Plan plan) {
  if (!planner.requirements) return plan;
  const PlanRequirements& own = *planner.requirements;
  const std::vector<verify::Violation> violations = planner.timed("verify", [&] {
    return verify::verify_plan(planner.robot, plan.demonstration, plan, own.config,
                               own.request ? &*own.request : nullptr);
  });
  if (violations.empty()) return plan;
  Plan rejected = fail(std::move(plan), failure_of(violations));
  rejected.branch = branch_of(planner.robot, rejected);
  return rejected;
}

}  // namespace morphe::planning
