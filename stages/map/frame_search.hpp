#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "core/solve/minimise.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe::map {

/// Somewhere inside the limits: the same on any machine.
JointVector random_start(const RobotTable& robot, std::mt19937_64& random);

/// Local minimum of one frame's objective from a start, by `options.algorithm`.
solve::Minimum solve_frame(const MappingProblem& problem, std::size_t frame,
                           const JointVector& start, const solve::MinimiseOptions& options,
                           MappingScratch& scratch);

/// With a limit that Newton's method comes far enough with; other algorithms keep their own.
solve::MinimiseOptions limited(solve::MinimiseOptions options, int evaluations);

/// Of a search: from every random start, and from the best that these found.
struct Descents {
  solve::MinimiseOptions first, then;
};
Descents thorough(const solve::MinimiseOptions& options);
/// As far as it takes to tell one minimum from another: they are followed and smoothed later.
Descents quick(const solve::MinimiseOptions& options);

/// Distinct local minima of one frame (more than 0.1 rad apart in some joint), the best first, at
/// most `keep` of them, from `starts` random positions inside the limits. The same seed gives the
/// same starts on any machine.
std::vector<solve::Minimum> search_frame(const MappingProblem& problem, std::size_t frame,
                                         int starts, int keep, const Descents& descents,
                                         std::uint64_t seed, MappingScratch& scratch);

}  // namespace morphe::map
