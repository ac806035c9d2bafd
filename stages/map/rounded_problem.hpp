#pragma once

#include "stages/map/mapping_problem.hpp"

namespace morphe::map {

/// A problem on a grid of an eighth of a millimetre and of a milliradian: goals, and where objects
/// lie. A search among many minima magnifies whatever its numbers differ by, be it the last digit
/// of a file; on the grid, recordings of one movement are one problem. Holds what it points to.
struct RoundedProblem {
  explicit RoundedProblem(MappingProblem exact);
  RoundedProblem(const RoundedProblem&) = delete;
  RoundedProblem& operator=(const RoundedProblem&) = delete;

  Scene scene;
  collision::CollisionWorld world;
  MappingProblem problem;
};

}  // namespace morphe::map
