#pragma once

#include <vector>

#include "core/solve/minimise_movement.hpp"
#include "stages/map/mapping_problem.hpp"
#include "stages/map/movement_cost.hpp"

namespace morphe::map {

/// Combines all frames of the problem and the movement's cost into one problem. On a coarser grid
/// each frame represents a longer time, in both sums alike. The problem and the scratch, which is
/// filled, must outlive the result.
solve::MovementProblem make_movement_problem(const MappingProblem& problem,
                                             const MovementCost& cost,
                                             std::vector<MappingScratch>& scratch);

}  // namespace morphe::map
