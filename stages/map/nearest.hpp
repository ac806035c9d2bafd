#pragma once

#include <vector>

#include "core/solve/minimise.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe::map {

/// How near the robot's tips can come to goals that it cannot reach: [F, m] each tip's distance
/// from its goal [m] where min_q sum ‖x_i(q) - goal_i‖² lies, inside the limits and with nothing
/// else asked for; NaN where there is no goal, and in frames that are reachable. A local minimum:
/// the better of those from the posture in `near` [F, n] and from the frame before.
JointRows nearest_errors(const MappingProblem& problem, const JointRows& near,
                         const std::vector<bool>& reachable, const solve::MinimiseOptions& solver);

}  // namespace morphe::map
