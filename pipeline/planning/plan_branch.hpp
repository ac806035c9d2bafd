#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::planning {

/// Returns the branch of the plan's trajectory or, without one, of its mapped path.
ArmBranch branch_of(const RobotModel& robot, const Plan& plan);

}  // namespace morphe::planning
