#pragma once

#include <cstdint>
#include <vector>

#include "core/solve/minimise.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe::map {

struct ReachOptions {
  int starts = 256;           ///< random ones, before a frame's goals are out of reach
  double tolerance_m = 1e-4;  ///< error below which a goal is met
  solve::MinimiseOptions solver;
};

/// A frame by itself, with nothing to ask but tip positions.
MappingProblem tips_alone(const MappingProblem& problem, std::size_t frame);

/// [F] whether the robot can reach a frame's fingertip goals, all of them at once: a solve without
/// the humanlikeness terms, from the posture in `near` [F, n], from one that reaches a neighbour's
/// goals, and then from up to `starts` random positions, brings every tip that has a goal within
/// the tolerance. Fewer where several of them have ended in one least value; none where another
/// frame's least error e proves it: goals that are d apart from that frame's (e and d the root of
/// the sum of squares over tips) leave at least e - d.
std::vector<bool> reachable_frames(const MappingProblem& problem, const JointRows& near,
                                   const ReachOptions& options, std::uint64_t seed);

}  // namespace morphe::map
