#pragma once

#include <vector>

#include "core/robot/robot.hpp"
#include "stages/simulate/options.hpp"

namespace morphe::simulate {

/// A position servo, torque = stiffness (control - q) - velocity_gain q̇, limited to
/// `torque_limit`, on a joint with the motor's inertia and friction. Units of the joint's first
/// frame: N m and rad, or N and m for a prismatic one.
struct Servo {
  double stiffness = 0, velocity_gain = 0;
  double armature = 0, damping = 0;
  double torque_limit = 0;
  /// time by which the control must lead a moving target for the joint to be on time,
  /// (velocity_gain + damping) / stiffness [s]
  double lead_s = 0;
};

/// Returns the servos of all joints. Those of the arm are the PA10's in order from the base (MuJoCo
/// models of it: stiffness 4000 … 500, armature 0.75 … 0.006, limits 158 … 17 N m), for any arm;
/// those of the hand follow the options; parameters in options.servos override both. [joints]
std::vector<Servo> servos_of(const robot::Robot& robot, const SimulateOptions& options);

/// Returns the first frame that each joint moves, which is the one with the motor. The value of a
/// frame is ratio * q + offset. [joints]
std::vector<int> motor_frames(const RobotModel& robot);

}  // namespace morphe::simulate
