#pragma once

#include <vector>

#include "stages/map/map_options.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe::map {

/// Returns the path, solved again near its findings against `problem.world`. Frames within
/// `window_s` of a finding may move; the others are held. Frames in which a joint moved by more
/// than kReSolvedChange_rad get the origin `re_solved`; the rest keep their positions exactly.
JointPath re_solve_path(const MappingProblem& problem, const JointPath& path,
                        const std::vector<Finding>& findings, const MapOptions& options,
                        double window_s = 0.3);

/// Does the same if the frames of a time interval may move, instead of those near findings.
JointPath re_solve_between(const MappingProblem& problem, const JointPath& path, double begin_s,
                           double end_s, const MapOptions& options);

}  // namespace morphe::map
