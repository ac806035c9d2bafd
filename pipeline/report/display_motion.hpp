#pragma once

#include "pipeline/report/plan_view.hpp"

namespace morphe::report {

/// Builds the displayed motion of a trajectory of a plan. `follows` is true if the trajectory
/// follows the goals, which approach and retreat do not. The world provides the poses at which the
/// target is carried.
DisplayMotion display_trajectory(const std::string& name, const collision::CollisionWorld& world,
                                 const Plan& plan, const Trajectory& trajectory, bool follows);

/// Builds the displayed motion of positions [rows, n] along the demonstration's own clock, from its
/// first time on.
DisplayMotion display_path(const std::string& name, const collision::CollisionWorld& world,
                           const Plan& plan, const JointRows& position,
                           const std::vector<double>& demonstration_time,
                           const std::vector<SampleOrigin>& origin);

}  // namespace morphe::report
