#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"
#include "stages/verify/violation_runs.hpp"

namespace morphe::verify {

/// Whether a plan has a grasp, or must have one: it has a phase grasp, and its target is there.
bool has_grasp(const Plan& plan);

/// Notes `grasp` for what a plan's grasp says that its trajectory and scene do not: `sample`, the
/// first at or after the phase grasp's begin (the last one if there is none); there, to 1e-6 m and
/// rad, `object_pose`, `wrist_pose_in_object`, `tips_in_object`, `approach_direction` and
/// `hand_posture`; and `pregrasp_posture`, that of a sample up to there at which thumb and index
/// are widest apart, to 1e-6 m; `missing` where there must be one and is none. False if the sample
/// is not that one, or there is no target: then nothing more can be judged at it.
bool judge_grasp_pose(const RobotTable& robot, const Plan& plan, ViolationRuns& runs);

}  // namespace morphe::verify
