#pragma once

#include <cstdint>
#include <vector>

#include "core/solve/minimise.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe::map {

/// Options of the reachability search.
struct ReachOptions {
  int starts = 256;               ///< random starts before a frame's goals are declared unreachable
  double tolerance_m = 1e-4;      ///< error below which a goal is reached
  solve::MinimiseOptions solver;  ///< options of each descent
};

/// Returns the problem of a single frame with tip positions as the only goals.
MappingProblem tip_position_problem(const MappingProblem& problem, std::size_t frame);

/// Returns [F] true if the robot can reach a frame's fingertip goals, all of them at once: damped
/// least squares without the humanlikeness terms brings every tip that has a goal within the
/// tolerance, from the posture in `near` [F, n], from one that reaches a neighbour's goals, or from
/// a minimum found from up to `starts` random positions. The search stops early if several starts
/// have ended in the same least value. It is omitted if the least error e of another frame proves
/// that the goals are unreachable: goals at a distance d from that frame's (e and d are the root of
/// the sum of squares over tips) leave an error of at least e - d.
std::vector<bool> reachable_frames(const MappingProblem& problem, const JointRows& near,
                                   const ReachOptions& options, std::uint64_t seed);

}  // namespace morphe::map
