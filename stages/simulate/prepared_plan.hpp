#pragma once

#include <optional>

#include "core/robot/robot.hpp"
#include "stages/simulate/grasp_command.hpp"
#include "stages/simulate/mjcf_text.hpp"
#include "stages/simulate/servo_commands.hpp"

namespace morphe::simulate {

/// A plan that has been prepared for any number of rollouts.
struct PreparedPlan {
  const robot::Robot* robot = nullptr;
  SimulatedWorld world;
  GraspCommand squeeze;
  ServoCommands program;
  Pose base_from_target = Pose::Identity(), palm_from_target = Pose::Identity();  ///< as planned
  std::optional<PlannedTask> task;  ///< absent: the target is lifted and held
  double planned_contact_s = 0;     ///< Rollout::contact_s if the robot followed the plan exactly
};

}  // namespace morphe::simulate
