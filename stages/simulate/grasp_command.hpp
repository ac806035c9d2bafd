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
  std::size_t tip = 0;  ///< index in the robot's table of tips
  /// in the target's frame [m]; unit, into the target, along which the finger presses
  Vec3 point, normal;
  double force_N = 0;
  Vec3 friction_force_N = Vec3::Zero();  ///< tangential force in the target's frame [N]
};

/// The squeeze that the hand is commanded to execute.
struct GraspCommand {
  std::vector<FingerForce> finger_forces;
  bool is_planned = false;     ///< true if the squeeze is the plan's own
  JointVector closed_posture;  ///< [n] posture in which the fingers touch
  /// [n] offset of the servo targets from closed_posture that produces the forces: Jᵀ force /
  /// stiffness
  JointVector servo_offset;
  /// share of the requested forces that the motors' torque limits permit, common to all fingers; <=
  /// 1
  double force_scale = 1;
};

/// Returns the plan's squeeze from the posture at which its trajectory ends. The fingers close to
/// their posture at the plan's grasp and aim beyond it by the plan's torques divided by the servos'
/// stiffness, which equals its servo_target if the stiffness is the planned one. Returns nullopt
/// if the plan has no squeeze, has fewer than two contacts with forces, or contains values that are
/// not finite.
std::optional<GraspCommand> planned_grasp_command(const robot::Robot& robot, const Plan& plan,
                                                  const JointVector& posture,
                                                  const std::vector<Servo>& servos);

/// Computes the squeeze for plans without one: closes the fingers of the given forces, starting
/// from a posture at the target, and computes the servo offsets. Only joints that move a tip and
/// not the palm are used.
GraspCommand make_grasp_command(const robot::Robot& robot, const JointVector& posture,
                                const Pose& base_from_target, const SceneObject& target,
                                std::vector<FingerForce> finger_forces,
                                const std::vector<Servo>& servos);

/// Returns finger forces for a plan without a squeeze. The thumb and every other finger that had a
/// goal at the grasp press, once closed, straight into the target at the point at which their last
/// links are nearest to it: the thumb with `force_N`, the others with equal shares of it. Returns
/// an empty vector, with the reason in `why_none`, if there is no thumb, no other finger or no
/// capsule at their tips.
std::vector<FingerForce> nearest_finger_forces(const robot::Robot& robot, const Plan& plan,
                                               const JointVector& posture, double force_N,
                                               std::string& why_none);

}  // namespace morphe::simulate
