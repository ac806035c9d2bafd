#pragma once

#include <vector>

#include "core/robot/robot.hpp"
#include "stages/simulate/options.hpp"

namespace morphe::simulate {

/// A position servo, torque = stiffness (control - q) - resistance q̇, no more than `torque`, on a
/// joint with the motor's inertia and friction. Units of the joint's first frame: N m and rad, N
/// and m where it slides.
struct Servo {
  double stiffness = 0, resistance = 0;
  double armature = 0, damping = 0;
  double torque = 0;
  /// How far ahead of a moving target the control must be to be there in time,
  /// (resistance + damping) / stiffness [s].
  double lead_s = 0;
};

/// [joints] Those of the arm are the PA10's by their place from the base (MuJoCo models of it:
/// stiffness 4000 … 500, armature 0.75 … 0.006, limits 158 … 17 N m), whatever the arm; those of
/// the hand as the options say; what options.servos says of a joint comes before both.
std::vector<Servo> servos_of(const robot::Robot& robot, const SimulateOptions& options);

/// [joints] The first frame that a joint moves: the one with the motor. The value of a frame is
/// ratio * q + offset.
std::vector<int> motor_frames(const RobotTable& robot);

}  // namespace morphe::simulate
