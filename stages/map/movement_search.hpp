#pragma once

#include <cstdint>
#include <vector>

#include "stages/map/map_options.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe::map {

/// A continuous way through the whole movement.
struct Course {
  JointRows q;       ///< a row per frame
  double value = 0;  ///< sum of the frames' objectives and of the movement cost
};

/// The whole movement smoothed at once from a start: objective of every frame plus
/// the movement's cost, inside the joint limits. First on the coarse grid, then all frames.
Course smooth_movement(const MappingProblem& problem, const JointRows& start,
                       const MapOptions& options);

/// The movement as one problem: minima of key frames are followed through it on a coarse grid,
/// smoothed as a whole, merged where they meet, and ordered by value, all of it with rounded goals
/// (rounded_problem.hpp). The first one is refined to every frame; the others stay on the coarse
/// grid's accuracy (interpolated to every frame) and are kept for repair.
std::vector<Course> search_movement(const MappingProblem& problem, const MapOptions& options,
                                    std::uint64_t seed);

/// The course that goes through (or near) a posture at a frame: followed from there to both ends on
/// the coarse grid, smoothed, and refined to every frame.
Course course_through(const MappingProblem& problem, std::size_t frame, const JointVector& posture,
                      const MapOptions& options);

}  // namespace morphe::map
