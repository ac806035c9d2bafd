#pragma once

#include "stages/map/mapping_problem.hpp"

namespace morphe::map {

/// A problem with goals and objects rounded to a grid of kGridStep_m and kGridStep_rad, and the
/// scene and world that it points to. A search among many minima amplifies any difference between
/// its inputs, even in the last digit of a file; the grid removes nearly all such differences.
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
