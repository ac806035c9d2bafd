#pragma once

#include <vector>

#include "core/solve/minimise_movement.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe::map {

/// Returns the indices of about evenly spaced frames, the first and the last among them. They are
/// about step_s apart, but there are at least kMinFrames if `time` (two or more) has as many.
std::vector<std::size_t> coarse_frames(const std::vector<double>& time, double step_s);

/// Returns the problem restricted to some of its frames.
MappingProblem problem_at_frames(const MappingProblem& problem,
                                 const std::vector<std::size_t>& frames);

/// Returns a row for every frame from frames.front() to frames.back(): the cubic Hermite polynomial
/// through the rows of `coarse`, one per frame of `frames`, with central differences as slopes.
JointRows interpolate(const JointRows& coarse, const std::vector<std::size_t>& frames);

/// Returns the rows of a movement at some of its frames.
JointRows rows_at(const JointRows& q, const std::vector<std::size_t>& frames);

/// Returns the options of a descent over all frames that starts from a solution on the coarse grid:
/// fewer iterations, a larger tolerance. Slow parts (fingers sliding on each other) have converged.
solve::MovementOptions fine_grid_options(solve::MovementOptions coarse);

}  // namespace morphe::map
