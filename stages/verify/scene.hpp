#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"
#include "stages/verify/violation_runs.hpp"

namespace morphe::verify {

/// Notes `scene` for what contradicts the plan within its own scene:
/// target          the movement's target is none of the objects
/// OBJECT          its name is there twice; it is carried and not the target; the frame that
/// carries
///                 it is none of the robot's, or there is no time to take it; it is taken elsewhere
///                 than at the end of the grasp, or released elsewhere than at the end of the last
///                 transport (1e-9 s); of a movement that ends before, or has no transport,
///                 released where the later of its own end and the grasp's is
/// world/table, world/target   not the middle of the top of the box `table` and the pose of the
///                 target as the movement begins (1e-6 m and of a matrix' entries), or there though
///                 the object is not
/// world/recording not a rigid motion
/// Where things stood in the recording, and what was not recorded, cannot be told from the plan.
void judge_scene(const RobotTable& robot, const Plan& plan, ViolationRuns& runs);

}  // namespace morphe::verify
