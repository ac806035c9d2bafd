#pragma once

#include <vector>

#include "core/motion/plan.hpp"
#include "stages/simulate/grasp_command.hpp"
#include "stages/simulate/planned_task.hpp"

namespace morphe::simulate {

/// The commands of a controller, one row per step. They do not depend on the simulated motion.
struct ServoCommands {
  JointVector start;                 ///< [n] posture before the first step
  JointRows control;                 ///< [steps, n] position targets of the servos
  JointRows reference;               ///< [steps, n] planned position after each step
  JointRows acceleration;            ///< [steps, n] planned, as feedforward for the motors
  std::vector<double> trajectory_s;  ///< trajectory's clock after each step that follows it
  /// Steps at which these parts end: trajectory; closing, squeezing and settling.
  Eigen::Index tracking_end = 0, grasp_end = 0;
  /// Without a task: lift; hold.
  Eigen::Index lift_end = 0, hold_end = 0;
  /// With a task: carrying; letting go and settling; the trajectory; standing. The last three are
  /// carry_end if the plan does not let go.
  Eigen::Index carry_end = 0, release_end = 0, leave_end = 0, stand_end = 0;
};

/// Returns the last sample of the phase `grasp` that begins at the plan's grasp.sample. After it
/// the fingers are closed.
Eigen::Index last_tracked_sample(const Plan& plan);

/// Computes the commands for steps of `step_s`. They follow the trajectory's quintics, with the
/// servos' lead; close the fingers; squeeze; lift along the rows of `lifting`, one per step, from
/// plan_lift(); and hold.
ServoCommands lift_commands(const Plan& plan, const std::vector<Servo>& servos,
                            const GraspCommand& squeeze, const JointRows& lifting, double step_s);

/// Computes the commands for the whole trajectory of a plan with a task. Its clock stops twice: at
/// the end of the grasp, as in lift_commands(), and at the release. In between, closing and squeeze
/// are added to the written motion; at the release they fade.
ServoCommands task_commands(const Plan& plan, const PlannedTask& task,
                            const std::vector<Servo>& servos, const GraspCommand& squeeze,
                            double step_s);

}  // namespace morphe::simulate
