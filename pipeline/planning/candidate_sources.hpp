#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/planning/infeasible_frame.hpp"
#include "stages/map/map_options.hpp"
#include "stages/map/mapping_problem.hpp"
#include "stages/repair/candidate_strategy.hpp"

namespace morphe::planning {

// The sources of candidate paths for a movement, the best of each kind first. `whole` is the
// mapping problem with the whole scene; arguments passed by reference must outlive the result.

/// Generates candidates that pass through postures which satisfy the goals at which the path
/// failed.
repair::NextCandidate candidates_through_postures(const map::MappingProblem& whole,
                                                  const map::MapOptions& options,
                                                  const std::vector<FeasiblePosture>& holds);

/// Generates the candidates kept by the mapping.
repair::NextCandidate mapping_candidates(const map::MappingProblem& whole,
                                         const std::vector<JointRows>& courses);

/// Generates candidates by new searches with the whole scene. A search runs when its first
/// candidate is requested; the searches end if no candidate of one was an improvement.
repair::NextCandidate searched_candidates(const map::MappingProblem& whole,
                                          const map::MapOptions& options, int searches,
                                          std::uint64_t seed);

}  // namespace morphe::planning
