#pragma once

#include <array>

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"
#include "stages/simulate/squeeze.hpp"

namespace morphe::simulate {

/// What a controller would send, a row a step; nothing in it knows what the simulation does.
struct Program {
  JointVector start;       ///< [n]
  JointRows control;       ///< [steps, n] targets of the servos
  JointRows reference;     ///< [followed, n] where the written trajectory is after that step
  JointRows acceleration;  ///< [followed, n] of it, that motors carry in that step
  /// Steps at which a part ends: the trajectory, the squeeze (closing and settling with it), the
  /// lift, the holding.
  Eigen::Index followed = 0, squeezed = 0, lifted = 0, held = 0;
};

/// The last sample of the plan's trajectory that is followed: the last of the phase `grasp` that
/// the grasp begins, or the trajectory's last. What comes then is this protocol's.
std::size_t last_followed(const Plan& plan);

/// Follows the trajectory (the quintics between its samples as each step begins, led by what the
/// servos lag behind), closes the fingers, squeezes, lifts by rows of lift(), holds.
Program program_of(const robot::Robot& robot, const Plan& plan, const std::vector<Servo>& servos,
                   const Squeeze& squeeze, const JointRows& lifting, double step_s);

}  // namespace morphe::simulate
