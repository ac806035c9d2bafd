#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/verify/violation_log.hpp"

namespace morphe::verify {

/// Records `scene` violations for contradictions between the plan and its own scene:
/// target          the movement's target is not among the objects
/// OBJECT          its name is not unique; it is attached and not the target; its attached frame
///                 does not exist in the robot; it is the target, which is always taken, and its
///                 attach time is missing or not the end of the grasp, or its release time is not
///                 the end of the last transport (1e-9 s). Without transport, it must not be
///                 released before the ends of movement and grasp, and may be later, because a part
///                 of a movement keeps its release time
/// reference_frames/table            not the middle of the top of the box `table`
/// reference_frames/target           not the pose of the target; both at the begin of the movement,
///                 to 1e-6 m and of the matrix entries, and absent if the object is
/// reference_frames/recording        not a rigid transform
/// The poses in the recording, and objects that were not recorded, cannot be determined from the
/// plan.
void verify_scene(const RobotModel& robot, const Plan& plan, ViolationLog& violations);

}  // namespace morphe::verify
