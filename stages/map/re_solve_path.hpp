#pragma once

#include <vector>

#include "stages/map/map_options.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe::map {

/// Re-solves a path near findings against `problem.world`. Frames within `reach_s` of a finding may
/// move, the others are held at their positions. Frames that moved by more than 1e-4 rad become
/// SampleOrigin::resolved.
JointPath re_solve_path(const MappingProblem& problem, const JointPath& path,
                        const std::vector<Finding>& findings, const MapOptions& options,
                        double reach_s = 0.3);

/// Does the same for the frames of a time interval, starting from the path itself.
JointPath re_solve_between(const MappingProblem& problem, const JointPath& path, double begin_s,
                           double end_s, const MapOptions& options);

}  // namespace morphe::map
