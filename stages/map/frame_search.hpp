#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "core/solve/minimise.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe::map {

/// Returns a random position inside the joint limits, the same on any machine.
JointVector random_start(const RobotModel& robot, std::mt19937_64& random);

/// Returns a local minimum of one frame's objective from a start, found by `options.algorithm`.
solve::Minimum solve_frame(const MappingProblem& problem, std::size_t frame,
                           const JointVector& start, const solve::MinimiseOptions& options,
                           MappingScratch& scratch);

/// Returns options with a limit on the evaluations, chosen so that Newton's method converges far
/// enough. Other algorithms keep their own limit.
solve::MinimiseOptions limit_evaluations(solve::MinimiseOptions options, int evaluations);

/// Options of the two stages of a search: from every random start, and from the best minima found
/// by these.
struct SearchStages {
  solve::MinimiseOptions first, then;  ///< options of the first and second stage
};
/// Returns the stages of a search in which the second stage has full accuracy.
SearchStages thorough_stages(const solve::MinimiseOptions& options);
/// Returns the stages of a search that only distinguishes minima, which are tracked and smoothed
/// later.
SearchStages quick_stages(const solve::MinimiseOptions& options);

/// Returns the distinct local minima of one frame (more than 0.1 rad apart in some joint), the best
/// first and at most `keep` of them, from `starts` random positions inside the limits. The same
/// seed gives the same starts on any machine.
std::vector<solve::Minimum> search_frame(const MappingProblem& problem, std::size_t frame,
                                         int starts, int keep, const SearchStages& descents,
                                         std::uint64_t seed, MappingScratch& scratch);

}  // namespace morphe::map
