#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/verify/violation_collector.hpp"

namespace morphe::verify {

/// Records `scene` violations for contradictions between the plan and its own scene:
/// target          the movement's target is not among the objects
/// OBJECT          its name is not unique; it is attached and not the target; its attached frame
///                 does not exist in the robot, or its attach time is missing; its attach time is
///                 not the end of the grasp, or its release time not the end of the last transport
///                 (1e-9 s); without transport, its release time is not the later of the ends of
///                 movement and grasp (later is allowed, for a part of a movement)
/// world/table, world/target   not the middle of the top of the box `table` and the pose of the
///                 target at the begin of the movement (1e-6 m and of the matrix entries), or
///                 present though the object is not
/// world/recording not a rigid transform
/// The poses in the recording, and objects that were not recorded, cannot be determined from the
/// plan.
void verify_scene(const RobotModel& robot, const Plan& plan, ViolationCollector& runs);

}  // namespace morphe::verify
