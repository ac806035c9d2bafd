#pragma once

#include <vector>

#include "core/solve/minimise.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe::map {

/// Computes the least errors of the robot's tips at goals that it cannot reach. The result [F, m]
/// contains each tip's distance from its goal [m] at the minimum of sum ‖x_i(q) - goal_i‖² inside
/// the limits, without any other term; NaN if there is no goal, and in reachable frames. The
/// minimum is local: the better of those from the posture in `near` [F, n] and from the previous
/// frame.
JointRows nearest_errors(const MappingProblem& problem, const JointRows& near,
                         const std::vector<bool>& reachable, const solve::MinimiseOptions& solver);

}  // namespace morphe::map
