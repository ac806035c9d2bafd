#pragma once

#include <vector>

#include "core/solve/minimise_movement.hpp"
#include "stages/map/mapping_problem.hpp"
#include "stages/map/movement_cost.hpp"

namespace morphe::map {

/// All frames of the problem and the movement's cost as one problem. On a coarser grid a frame
/// stands for more time, in both sums alike. Problem and scratch, which is filled, must outlive it.
solve::MovementProblem whole_movement(const MappingProblem& problem, const MovementCost& cost,
                                      std::vector<MappingScratch>& scratch);

}  // namespace morphe::map
