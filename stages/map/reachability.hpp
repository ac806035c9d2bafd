#pragma once

#include <cstdint>
#include <vector>

#include "core/solve/minimise.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe::map {

/// Options of the reachability search.
struct ReachOptions {
  int starts = 256;           ///< random starts before a frame's goals are declared unreachable
  double tolerance_m = 1e-4;  ///< error below which a goal is reached
  solve::MinimiseOptions solver;
};

/// Returns the problem of a single frame with tip positions as the only goals.
MappingProblem tip_position_problem(const MappingProblem& problem, std::size_t frame);

/// Returns [F]: true if the robot can reach a frame's fingertip goals, all at once. It can if
/// damped least squares brings every tip that has a goal within the tolerance, from one of
///   the posture of the frame in `path` [F, n],
///   a posture that reaches the goals of a frame nearby, or
///   a minimum found from up to `starts` random positions (fewer near an unreachable frame, and if
///   several end in the same least value).
/// There is no search if another frame proves that the goals are unreachable: if its least error is
/// e, goals at a distance d from its goals leave an error of at least e - d (e and d are roots of
/// sums of squares over the tips).
std::vector<bool> reachable_frames(const MappingProblem& problem, const JointRows& path,
                                   const ReachOptions& options, std::uint64_t seed);

}  // namespace morphe::map
