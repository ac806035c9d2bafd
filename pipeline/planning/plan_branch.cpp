#include "pipeline/planning/plan_branch.hpp"

#include "core/robot/arm_branch.hpp"

namespace morphe::planning {

ArmBranch branch_of(const RobotModel& robot, const Plan& plan) {
  const Trajectory& driven = plan.trajectory;
  if (driven.samples() > 0)
    return robot::branch_of_path(robot, driven.position, driven.demonstration_time);
  return robot::branch_of_path(robot, plan.mapped.position, plan.goals.time);
}

}  // namespace morphe::planning
