#pragma once

#include <cstdint>
#include <vector>

#include "stages/map/map_options.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe::map {

/// A continuous path through the whole movement.
struct CandidatePath {
  JointRows q;       ///< [F, n] joint positions
  double value = 0;  ///< sum of the frames' objectives and of the movement cost
};

/// Smooths the whole movement from a start: minimises the objective of every frame plus the
/// movement's cost inside the joint limits, first on the coarse grid, then over all frames.
CandidatePath smooth_movement(const MappingProblem& problem, const JointRows& start,
                              const MapOptions& options);

/// Searches for candidate paths with the movement as one problem. Minima of key frames are tracked
/// through it on a coarse grid, joined into sequences, smoothed as a whole and ordered by value,
/// all of this with rounded goals (rounded_problem.hpp). The first path is refined over all frames;
/// the others keep the accuracy of the coarse grid (interpolated to every frame) for repair.
std::vector<CandidatePath> search_movement(const MappingProblem& problem, const MapOptions& options,
                                           std::uint64_t seed);

/// Returns the path that passes through (or near) a posture at a frame: tracked from there to both
/// ends on the coarse grid, smoothed, and refined over all frames.
CandidatePath path_through(const MappingProblem& problem, std::size_t frame,
                           const JointVector& posture, const MapOptions& options);

}  // namespace morphe::map
