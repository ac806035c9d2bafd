#pragma once

#include <string>

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"
#include "stages/verify/violation_runs.hpp"

namespace morphe::verify {

/// Notes `squeeze` for what is wrong with the forces and torques beside the trajectory:
/// <tip>/force     a contact that presses with less than 0, or more than the config's
/// squeeze_force;
///                 a force of one that does not touch
/// <tip>/cone      friction not at right angles to the normal, or outside of the cone; 1e-6 of the
///                 force
/// balance         what is left of all wrenches (torques over the torque scale), less what moments
///                 within the cones can take: 3 % of the largest force and 2 mN
/// torque          not J^T f of the fingers' joints, 1e-6 N m; or more than the config's
///                 joint_torque, 1e-6 of it
/// servo_target    not hand_posture + torque / stiffness, 1e-6 rad; the stiffness is the config's
/// or,
///                 where that cannot be read, the one that fits best
/// trajectory      a sample from the grasp on has the fingers where the squeeze sends them
/// A grasp of which fewer than two contacts touch has no squeeze.
void judge_squeeze(const RobotTable& robot, const Plan& plan, const std::string& config,
                   ViolationRuns& runs);

}  // namespace morphe::verify
