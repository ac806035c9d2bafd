#pragma once

#include <string>

#include "core/motion/plan_request.hpp"
#include "pipeline/planning/planner.hpp"

namespace morphe::planning {

/// The requirements that `verify` will read from the header of the plans' file.
struct PlanRequirements {
  std::string config;  ///< as stored in the header
  PlanRequest request;
};

/// Returns the requirements on plans made with a config, by way of their header. Throws InputError
/// if the header does not say them: if files of one name have no common folder, so that the stored
/// ones do not find each other.
PlanRequirements requirements_of(const LoadedConfig& config);

/// Verifies a plan as `verify` will, with code that shares nothing with planning. Returns the plan;
/// one with violations becomes infeasible, with the reason `rejected` and the first violation.
/// Returns the plan unchanged if the planner has no requirements.
Plan verified(const PlanningInputs& planner, Plan plan);

}  // namespace morphe::planning
