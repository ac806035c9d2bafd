#pragma once

#include <string>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/verify/violation_collector.hpp"

namespace morphe::verify {

/// Records `squeeze` violations of the forces and torques stored beside the trajectory:
/// <tip>/force     a normal force is negative or exceeds the config's max_finger_force; a force at
/// a
///                 contact that does not touch
/// <tip>/cone      friction is not perpendicular to the normal, or is outside of the friction cone;
///                 1e-6 of the force
/// balance         the sum of all wrenches (torques divided by the torque scale), less the moments
///                 that the cones permit; 3 % of the largest force and 2 mN
/// torque          not J^T f of the finger joints, 1e-6 N m; or more than the config's
///                 joint_torque, 1e-6 of it
/// servo_target    not grasp_posture + torque / stiffness, 1e-6 rad; the stiffness is the config's
///                 or, if that cannot be read, the one that fits best
/// trajectory      at a sample from the grasp on, the fingers are at the squeeze's posture
/// A grasp with fewer than two touching contacts has no squeeze.
void verify_grasp_forces(const RobotModel& robot, const Plan& plan, const std::string& config,
                         ViolationCollector& runs);

}  // namespace morphe::verify
