#pragma once

#include "stages/map/mapping_problem.hpp"

namespace morphe::map {

/// A problem with goals and object poses rounded to a grid of an eighth of a millimetre and of a
/// milliradian. A search among many minima amplifies any difference of its inputs, be it the last
/// digit of a file; on the grid, recordings of one movement are the same problem. The object owns
/// the data to which its problem points.
struct RoundedProblem {
  /// Rounds a problem.
  explicit RoundedProblem(MappingProblem exact);
  RoundedProblem(const RoundedProblem&) = delete;
  RoundedProblem& operator=(const RoundedProblem&) = delete;

  Scene scene;
  collision::CollisionWorld world;
  MappingProblem problem;
};

}  // namespace morphe::map
