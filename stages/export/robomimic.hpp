#pragma once

#include <string>

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"
#include "stages/export/robomimic_file.hpp"

namespace morphe::exports {

/// Joint positions scaled by the joints' limits; env_args names the robot (there is no simulator to
/// make one from), the controller's rate and the order of joints and tips. InputError for a joint
/// without finite limits.
RobomimicHeader robomimic_header(const RobotTable& robot, double rate_hz);

/// An executable plan with T samples as T - 1 transitions: the action at a sample is the position
/// at the next one. Observations, positions in the base frame [m, rad]:
///   joint_positions, joint_velocities [n]   tip_positions [3 m] tip by tip
///   palm_position [3]  palm_orientation [4] (w, x, y, z)   demonstration_phase [7], one of seven 1
///   with `target`: target_position [3]  target_orientation [4], of the object where it is grasped
RobomimicDemo robomimic_demo(const RobotTable& robot, const Plan& plan, bool target);

}  // namespace morphe::exports
