#pragma once

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"
#include "stages/simulate/grasp_command.hpp"

namespace morphe::simulate {

/// The commands of a controller, one row per step. They do not depend on the simulated motion.
struct ServoCommands {
  JointVector start;       ///< [n] posture before the first step
  JointRows control;       ///< [steps, n] position targets of the servos
  JointRows reference;     ///< [tracking_end, n] planned position after each step
  JointRows acceleration;  ///< [tracking_end, n] planned, as feedforward for the motors
  /// Steps at which these parts end: trajectory; closing, squeezing and settling; lift; hold.
  Eigen::Index tracking_end = 0, grasp_end = 0, lift_end = 0, hold_end = 0;
};

/// Returns the last sample of the phase `grasp` that begins at the plan's grasp.sample. After it
/// the fingers are closed.
Eigen::Index last_tracked_sample(const Plan& plan);

/// Computes the commands for steps of `step_s`. They follow the trajectory's quintics, with the
/// servos' lead; close the fingers; squeeze; lift along the rows of `lifting`, one per step, from
/// plan_lift(); and hold.
ServoCommands make_servo_commands(const robot::Robot& robot, const Plan& plan,
                                  const std::vector<Servo>& servos, const GraspCommand& squeeze,
                                  const JointRows& lifting, double step_s);

}  // namespace morphe::simulate
