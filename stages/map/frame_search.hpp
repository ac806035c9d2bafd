#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/solve/minimise.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe {

/// Local minimum of one frame's objective from a start, by NLopt.
Minimum solve_frame(const MappingProblem& problem, std::size_t frame, const JointVector& start,
                    const MinimiseOptions& options, MappingScratch& scratch);

/// Distinct local minima of one frame (more than 0.1 rad apart in some joint), the best first, at
/// most `keep` of them, from `starts` random positions inside the limits. The same seed gives the
/// same starts on any machine.
std::vector<Minimum> search_frame(const MappingProblem& problem, std::size_t frame, int starts,
                                  int keep, const MinimiseOptions& options, std::uint64_t seed,
                                  MappingScratch& scratch);

/// Which goals of a frame the robot can reach: the best of solves without the humanlikeness terms,
/// from `near` and then from up to `starts` random positions, until every tip that has a goal is
/// within `tolerance_m`. [tips], 1 or 0; 0 also where there is no goal.
std::vector<std::uint8_t> reachable_goals(const MappingProblem& problem, std::size_t frame,
                                          const JointVector& near, int starts, double tolerance_m,
                                          const MinimiseOptions& options, std::uint64_t seed,
                                          MappingScratch& scratch);

}  // namespace morphe
