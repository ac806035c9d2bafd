#pragma once

#include <vector>

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

/// Returns the mapping problem that repair solves: the movement in the whole scene. The clearance
/// of a hand alone begins at a smaller distance (kHandAloneBandScale).
map::MappingProblem whole_problem(const map::MappingProblem& problem,
                                  const collision::CollisionWorld& world);

/// Returns the strategies that change the mapping least.
///   an arm        while the path collides, it is solved again near its findings in the whole
///                 scene, with 10 and then 100 times the weight of clearance
///   a hand alone  the same with 100 and 10000 times the weight at 0.4 of the distance, then with
///                 1000 times the weight at all of it; then, as fingers that are caught in each
///                 other are freed by no small motion, again near its collisions, starting from
///                 repair::bridge_collisions()
std::vector<repair::RepairStrategy> first_re_solves(const ReSolveContext& context);

/// Returns the strategy that solves the path again with up to three sets of weights, until it is
/// free:
///   1. 1000 times the weight of the clearance term, while the path collides
///   2. 10000 times, at a fifth of the distance, so that tips do not yield to needless clearance
///   3. kStrongestWeights: tips and clearance alone determine the result
repair::RepairStrategy re_solve_strongly(const ReSolveContext& context);

}  // namespace morphe::planning
