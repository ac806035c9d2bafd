#pragma once

#include <vector>

#include "core/robot/robot.hpp"
#include "stages/simulate/options.hpp"

namespace morphe::simulate {

/// A position servo, torque = stiffness (control - q) - velocity_gain q̇ within its limit, on a
/// joint with motor inertia and friction [N m, rad, or N, m if prismatic].
struct Servo {
  double stiffness = 0, velocity_gain = 0, armature = 0, damping = 0, torque_limit = 0;
  double lead_s =
      0;  ///< times q̇ is added to a moving target: (velocity_gain + damping) / stiffness
};

/// Returns the servos [joints]. The joints of any arm have those of the PA10 in order from the
/// base, finger joints those of the options, and prismatic joints those of a gripper. Parameters in
/// options.servos override all of these.
std::vector<Servo> servos_of(const robot::Robot& robot, const SimulateOptions& options);

/// Returns for each joint the first frame that it moves. That frame has the motor; its value is
/// ratio * q + offset.
std::vector<int> motor_frames(const RobotModel& robot);

}  // namespace morphe::simulate
