#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"
#include "stages/simulate/servos.hpp"

namespace morphe::simulate {

/// The contribution of one finger to a squeeze: a force on the target at a point of its surface.
struct FingerForce {
  int tip = 0;                           ///< index in the robot's table of tips
  Vec3 point, normal;                    ///< in the target's frame; unit, into the target
  double force_N = 0;                    ///< component along the normal
  Vec3 friction_force_N = Vec3::Zero();  ///< tangential, in the target's frame
};

/// The squeeze that the hand is commanded to execute.
struct GraspCommand {
  std::vector<FingerForce> finger_forces;
  bool is_planned = false;     ///< true if the squeeze is the plan's own
  JointVector closed_posture;  ///< [n] posture in which the fingers touch
  JointVector servo_offset;    ///< [n] targets less closed_posture: Jᵀ force / stiffness
  double force_scale = 1;      ///< share of all forces that the motors' torque limits permit, <= 1
};

/// Returns the plan's squeeze. The arm stays as in `posture`, at which the trajectory ends. The
/// fingers close to their posture at the plan's grasp; the servos' targets are beyond it by the
/// plan's torques divided by the servos' stiffness. They equal the plan's servo_target if the
/// stiffness is the planned one. Returns nullopt if the plan's squeeze is missing or not finite, or
/// has fewer than two contacts with forces.
std::optional<GraspCommand> planned_grasp_command(const robot::Robot& robot, const Plan& plan,
                                                  const JointVector& posture,
                                                  const std::vector<Servo>& servos);

/// Computes the squeeze for plans without one. Closes the fingers that `finger_forces` names, from
/// `posture` and by joints that are not the arm's, until they touch the target; then computes the
/// servo offsets.
GraspCommand make_grasp_command(const robot::Robot& robot, const JointVector& posture,
                                const Pose& base_from_target, const SceneObject& target,
                                std::vector<FingerForce> finger_forces,
                                const std::vector<Servo>& servos);

/// Returns finger forces for a plan without a squeeze. The thumb and every other finger that had a
/// goal at the grasp press, once closed, straight into the target at the point at which their last
/// links are nearest to it: the thumb with `force_N`, the others with equal shares of it. Empty,
/// with the reason, if there is no thumb, no other finger or no capsule at their tips.
std::vector<FingerForce> nearest_finger_forces(const robot::Robot& robot, const Plan& plan,
                                               const JointVector& posture, double force_N,
                                               std::string& reason);

}  // namespace morphe::simulate
