#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/verify/violation_collector.hpp"

namespace morphe::verify {

/// Returns true if a plan has a grasp or must have one, that is, it has a phase grasp and its
/// target is in the scene.
bool has_grasp(const Plan& plan);

/// Records `grasp` violations for each property of a plan's grasp that its trajectory and scene do
/// not confirm: `sample`, which must be the first one at or after the begin of the phase grasp (the
/// last sample if there is none); at that sample, to 1e-6 m and rad, `object_pose`,
/// `palm_pose_in_object`, `tips_in_object`, `approach_direction` and `grasp_posture`;
/// `pregrasp_posture`, which must be that of a sample up to there at which thumb and index are
/// farthest apart, to 1e-6 m; `missing` if a grasp is required and absent. Returns false if the
/// sample is wrong or there is no target; the grasp cannot be verified any further then.
bool verify_grasp_pose(const RobotModel& robot, const Plan& plan, ViolationCollector& runs);

}  // namespace morphe::verify
