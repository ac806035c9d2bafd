#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/enum_names.hpp"
#include "stages/simulate/prepared_plan.hpp"

namespace morphe::simulate {

/// The reason for which a plan cannot be simulated; invalid_data includes a mesh without a volume.
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
  std::string detail;              ///< sentence about skip_reason; may be left if it is none
  std::vector<std::string> notes;  ///< assumptions that were made, one sentence each
};

/// Prepares a plan for simulation. Robot and plan must outlive the result.
PreparationResult prepare(const robot::Robot& robot, const Plan& plan,
                          const SimulateOptions& options);

}  // namespace morphe::simulate
