#pragma once

#include "pipeline/report/plan_view.hpp"

namespace morphe::report {

/// A trajectory of a plan as it is shown; `follows` the goals: approach and retreat do not. The
/// world knows where the target is carried.
ShownMotion shown_trajectory(const std::string& name, const collision::CollisionWorld& world,
                             const Plan& plan, const Trajectory& trajectory, bool follows);

/// Positions along the demonstration's own clock, [rows, n], from its first time on.
ShownMotion shown_path(const std::string& name, const collision::CollisionWorld& world,
                       const Plan& plan, const JointRows& position,
                       const std::vector<double>& demonstration_time,
                       const std::vector<Origin>& origin);

}  // namespace morphe::report
