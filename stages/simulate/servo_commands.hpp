#pragma once

#include <array>

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"
#include "stages/simulate/grasp_command.hpp"

namespace morphe::simulate {

/// The commands of a controller, one row per step; they are independent of the simulated motion.
struct ServoCommands {
  JointVector start;    ///< [n]
  JointRows control;    ///< [steps, n] position targets of the servos
  JointRows reference;  ///< [followed, n] planned position after each step
  /// [followed, n] planned acceleration, as feedforward for the motors in each step
  JointRows acceleration;
  /// Steps at which a part ends: the trajectory, the grasp (closing, squeezing and settling), the
  /// lift, the hold.
  Eigen::Index tracking_end = 0, grasp_end = 0, lift_end = 0, hold_end = 0;
};

/// Returns the last sample of the plan's trajectory that is executed: the last one of the phase
/// `grasp` that begins the grasp, or the trajectory's last. The protocol continues from there.
std::size_t last_tracked_sample(const Plan& plan);

/// Computes the commands that follow the trajectory (the quintics between its samples at the begin
/// of each step, advanced by the lag of the servos), close the fingers, squeeze, lift along the
/// rows of `lifting` from plan_lift(), and hold.
ServoCommands make_servo_commands(const robot::Robot& robot, const Plan& plan,
                                  const std::vector<Servo>& servos, const GraspCommand& squeeze,
                                  const JointRows& lifting, double step_s);

}  // namespace morphe::simulate
