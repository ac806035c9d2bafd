#pragma once

#include "stages/map/map_options.hpp"
#include "stages/map/mapping_problem.hpp"
#include "stages/repair/repair_strategy.hpp"

namespace morphe::planning {

/// The inputs of re-solving. The referenced objects must outlive the strategies.
struct ReSolveContext {
  const map::MappingProblem& whole;  ///< the movement in the whole scene
  const map::MapOptions& options;
  repair::PathCheck check;
};

/// Returns the strategy for a hand alone, whose fingers are near each other most of the time: with
/// 10, 100 and 1000 times the weight of clearance, but at a fifth of the distance, so that fingers
/// which are clear of each other keep their goals.
repair::RepairStrategy re_solve_closely(const ReSolveContext& context);

/// Returns the strategy that changes the mapping least: while the path collides, it is solved again
/// near its findings in the whole scene, with 10 and then 100 times the weight of clearance.
repair::RepairStrategy re_solve_mildly(const ReSolveContext& context);

/// Returns the strategy that solves the path again with up to three sets of weights, until it is
/// free:
///   1. 1000 times the weight of the clearance term, while the path collides
///   2. 10000 times, at a fifth of the distance, so that tips do not yield to needless clearance
///   3. kStrongestWeights: tips and clearance alone determine the result
repair::RepairStrategy re_solve_strongly(const ReSolveContext& context);

}  // namespace morphe::planning
