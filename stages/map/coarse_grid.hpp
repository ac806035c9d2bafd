#pragma once

#include <vector>

#include "core/solve/minimise_movement.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe::map {

/// Returns the frames of an evenly spaced grid that contains the first and the last frame. The
/// frames are about step_s apart and at least five, if there are that many.
std::vector<std::size_t> coarse_frames(const std::vector<double>& time, double step_s);

/// Returns the problem restricted to some of its frames.
MappingProblem problem_at_frames(const MappingProblem& problem,
                                 const std::vector<std::size_t>& frames);

/// Interpolates a row for every frame from the first to the last of `frames` by cubic Hermite
/// polynomials with central differences as slopes: the velocity is continuous and the rows of
/// `frames` are as given.
JointRows interpolate(const JointRows& coarse, const std::vector<std::size_t>& frames);

/// Returns the rows of a movement at some of its frames.
JointRows rows_at(const JointRows& q, const std::vector<std::size_t>& frames);

/// Returns the options for all frames after the coarse grid. Parts of the solution that converge
/// slowly, such as fingers that slide along each other, have converged on the coarse grid; only the
/// motion between its frames remains.
solve::MovementOptions fine_grid_options(solve::MovementOptions coarse);

}  // namespace morphe::map
