#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/planning/infeasible_frame.hpp"
#include "stages/map/map_options.hpp"
#include "stages/map/mapping_problem.hpp"
#include "stages/repair/candidate_strategy.hpp"

namespace morphe::planning {

// The sources of candidate paths for a movement. Each returns its candidates in order, the most
// promising first. `whole` is the mapping problem with the whole scene. Arguments passed by
// reference must outlive the result.

/// Generates a candidate through each posture. Postures may be added until all are used.
repair::NextCandidate candidates_through_postures(const map::MappingProblem& whole,
                                                  const map::MapOptions& options,
                                                  const std::vector<FeasiblePosture>& postures);

/// Generates the candidates that the mapping has kept, unchanged: joint positions [frames, n].
repair::NextCandidate mapping_candidates(const map::MappingProblem& whole,
                                         const std::vector<JointRows>& kept_paths);

/// Generates candidates by at most `searches` new mapping searches. A search runs when its first
/// candidate is requested, and only if the search before it has led to an improvement.
repair::NextCandidate searched_candidates(const map::MappingProblem& whole,
                                          const map::MapOptions& options, int searches,
                                          std::uint64_t seed);

}  // namespace morphe::planning
