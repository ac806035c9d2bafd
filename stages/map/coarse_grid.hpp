#pragma once

#include <vector>

#include "core/solve/minimise_movement.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe::map {

/// Frames of an evenly spaced grid that holds the first and the last frame, about step_s apart and
/// at least five, if there are so many.
std::vector<std::size_t> coarse_frames(const std::vector<double>& time, double step_s);

/// The problem at some of its frames.
MappingProblem on_frames(const MappingProblem& problem, const std::vector<std::size_t>& frames);

/// A row for every frame from the first to the last of `frames`, cubic between theirs (Hermite,
/// with central differences for slopes): continuous velocity, the rows of `frames` as given.
JointRows interpolate(const JointRows& coarse, const std::vector<std::size_t>& frames);

/// The rows of a movement at some of its frames.
JointRows rows_at(const JointRows& q, const std::vector<std::size_t>& frames);

/// What all frames take after the coarse grid: what is slow to settle, as fingers that slide along
/// each other, is settled there; left is what lies between its frames.
solve::MovementOptions for_all_frames(solve::MovementOptions coarse);

}  // namespace morphe::map
