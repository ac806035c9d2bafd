#pragma once

#include <cstdint>

#include "pipeline/solve/minimise.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe {

/// Whether the robot can reach a frame's fingertip goals, all of them at once: a solve without the
/// humanlikeness terms, from `near` and then from up to `starts` random positions, brings every tip
/// that has a goal within `tolerance_m`. Fewer where several of them have ended in one least value.
bool goals_reachable(const MappingProblem& problem, std::size_t frame, const JointVector& near,
                     int starts, double tolerance_m, const MinimiseOptions& options,
                     std::uint64_t seed, MappingScratch& scratch);

}  // namespace morphe
