#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/verify/violation_log.hpp"

namespace morphe::verify {

/// Returns true if a plan has a grasp, or must: its phases include a grasp and its target exists.
bool has_grasp(const Plan& plan);

/// Records `grasp` violations for properties of a plan's grasp that its trajectory and scene do not
/// confirm; tolerance 1e-6 m, rad and of matrix entries:
/// missing           a grasp is required and absent
/// sample            not the first at or after the begin of the phase grasp (else the last sample)
/// target            not among the objects
/// grasp_posture, object_pose, palm_pose_in_object, tips_in_object   not those of that sample
/// approach_direction  not the direction of the palm's way to that sample
/// pregrasp_posture  not that of the sample, up to the grasp, with the greatest distance from thumb
///                   to index
/// Returns false if target or sample are wrong; the grasp cannot be verified any further then.
bool verify_grasp_pose(const RobotModel& robot, const Plan& plan, ViolationLog& violations);

}  // namespace morphe::verify
