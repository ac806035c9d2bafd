#pragma once

#include <cstdint>
#include <vector>

#include "stages/map/choose_branch.hpp"
#include "stages/map/map_options.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe::map {

/// Smooths a path `start` [F, n]: minimises the sum of the frames' objectives and of the movement's
/// cost inside the joint limits, first with rounded goals on the coarse grid, then over all frames.
CandidatePath smooth_movement(const MappingProblem& problem, const JointRows& start,
                              const MapOptions& options);

/// Searches for candidate paths of the whole movement. On a coarse grid and with rounded goals
/// (rounded_problem.hpp), it tracks minima of key frames, joins them into sequences, smooths these
/// and orders them by value. The first path is then refined over all frames, with the exact goals.
/// The others, for repair, are interpolated from the coarse grid, on which their value is given.
std::vector<CandidatePath> search_movement(const MappingProblem& problem, const MapOptions& options,
                                           std::uint64_t seed);

/// Returns a path through or near a posture at a frame, the last one if it is beyond that: tracked
/// from there to both ends, smoothed on the coarse grid and refined over all frames.
CandidatePath path_through(const MappingProblem& problem, std::size_t frame,
                           const JointVector& posture, const MapOptions& options);

}  // namespace morphe::map
