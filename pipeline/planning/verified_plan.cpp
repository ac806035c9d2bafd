#include "pipeline/planning/verified_plan.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "core/motion/count_with_noun.hpp"
#include "core/motion/input_error.hpp"
#include "core/store/plan_header.hpp"
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
  PlanFileHeader header = header_of(config, "");
  header.inputs_sha256 = store::inputs_hash(header);
  const char* const advice =
      "plans.h5 cannot keep the files of this config so that it finds them again: put them into "
      "one folder, or give different names to files of the same name";
  try {
    PlanRequest request = plan_requirements(header);
    if (request.header_faults.empty()) return {header.config, std::move(request)};
    throw InputError(request.header_faults.front());
  } catch (const InputError& error) {
    throw InputError(fmt::format("{} ({})", advice, error.what()));
  }
}

Plan verified(const PlanningInputs& planner, Plan plan) {
  if (!planner.requirements) return plan;
  const PlanRequirements& own = *planner.requirements;
  const std::vector<verify::Violation> violations = planner.timed("verify", [&] {
    return verify::verify_plan(planner.robot, plan.demonstration, plan, own.config, &own.request);
  });
  if (violations.empty()) return plan;
  Plan rejected = fail(std::move(plan), failure_of(violations));
  rejected.branch = branch_of(planner.robot, rejected);
  return rejected;
}

}  // namespace morphe::planning
