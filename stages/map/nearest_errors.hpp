#pragma once

#include <vector>

#include "core/solve/minimise.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe::map {

/// Returns [F, m]: each tip's distance from its goal [m] at the minimum of sum ‖x_i(q) - goal_i‖²
/// inside the limits, without any other term; NaN without a goal and in reachable frames. The
/// minimum is local: the better of those found from `path` [F, n] and from the previous frame's.
JointRows nearest_errors(const MappingProblem& problem, const JointRows& path,
                         const std::vector<bool>& reachable, const solve::MinimiseOptions& solver);

}  // namespace morphe::map
