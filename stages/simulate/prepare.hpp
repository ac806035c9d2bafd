#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/enum_names.hpp"
#include "stages/simulate/rollout.hpp"

namespace morphe::simulate {

/// The reason for which a plan cannot be simulated: it is infeasible; it contains no grasp; its
/// values are not finite or its target's mesh encloses no volume; no two fingers can press against
/// each other; the arm cannot lift the target.
enum class SkipReason {
  none,
  infeasible,
  no_grasp,
  invalid_data,
  no_opposing_fingers,
  lift_infeasible
};
constexpr std::array<std::string_view, 6> names_of(SkipReason) {
  return {"none",         "infeasible",          "no_grasp",
          "invalid_data", "no_opposing_fingers", "lift_infeasible"};
}

/// The result of preparing a plan.
struct PreparationResult {
  PreparedPlan plan;
  SkipReason skip_reason = SkipReason::none;
  std::string detail;              ///< a sentence; "" if the plan can be simulated
  std::vector<std::string> notes;  ///< assumptions that were made, one sentence each
};

/// Prepares a plan for simulation. Robot and plan must outlive the result.
PreparationResult prepare(const robot::Robot& robot, const Plan& plan,
                          const SimulateOptions& options);

}  // namespace morphe::simulate
