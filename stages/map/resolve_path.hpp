#pragma once

#include <vector>

#include "stages/map/map_options.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe::map {

/// Re-solves a path near findings against `problem.world`: frames within `reach_s` of a finding may
/// move, the others are drawn to where they are. Frames that moved by more than 1e-4 rad become
/// Origin::resolved.
JointPath resolve_path(const MappingProblem& problem, const JointPath& path,
                       const std::vector<Finding>& findings, const MapOptions& options,
                       double reach_s = 0.3);

/// The same for the frames of a time, from where the path is.
JointPath resolve_between(const MappingProblem& problem, const JointPath& path, double begin_s,
                          double end_s, const MapOptions& options);

}  // namespace morphe::map
