#pragma once

#include "stages/map/map_options.hpp"
#include "stages/map/mapping_problem.hpp"
#include "stages/repair/repair_strategy.hpp"

namespace morphe::planning {

/// The inputs of re-solving; all except `check` must outlive the strategies.
struct ReSolveContext {
  const map::MappingProblem& whole;  ///< the movement in the whole scene
  const map::MapOptions& options;
  repair::PathCheck check;
};

/// Returns the strategy that changes the mapping least: it solves the path again near its findings
/// in the whole scene, with increasing weights of the clearance term until the tips yield.
repair::RepairStrategy re_solve_mildly(const ReSolveContext& solving);

/// Returns the strategy that solves the path again with the weights necessary to free it: if tips
/// have yielded to more clearance than required, only freedom from collision is requested; finally,
/// tips and clearance alone determine the result.
repair::RepairStrategy re_solve_strongly(const ReSolveContext& solving);

}  // namespace morphe::planning
