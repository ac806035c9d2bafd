#pragma once

#include <string>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/verify/violation_log.hpp"

namespace morphe::verify {

/// Records `grasp_force` violations of the forces and torques stored beside the trajectory:
/// <tip>/normal_force   negative, or exceeds the config's max_finger_force; or a force is stored
///                      for a contact that does not touch
/// <tip>/friction_cone  friction is not perpendicular to the normal, or is outside of the friction
///                      cone; 1e-6 max(1 N, normal force)
/// force_balance        the sum of all wrenches (torques divided by characteristic_length) remains
///                      beyond the moments that the cones permit; 3 % of the largest force and 2 mN
/// torque               not J^T f of the finger joints, 1e-6 N m; more than the config's
///                      max_joint_torque, 1e-6 of it; or absent though epsilon_lower > 1e-3
/// servo_target         not grasp_posture + torque / stiffness, 1e-6 rad; the stiffness is the
///                      config's or, if that cannot be read, the one that fits best
/// trajectory           at a sample from the grasp on, the fingers have the posture servo_target
/// A grasp with fewer than two touching contacts must have no forces.
void verify_grasp_forces(const RobotModel& robot, const Plan& plan, const std::string& config,
                         ViolationLog& violations);

}  // namespace morphe::verify
