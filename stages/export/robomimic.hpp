#pragma once

#include <string>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/export/robomimic_file.hpp"

namespace morphe::exports {

/// Returns the header of a file: joint positions are scaled by the joint limits; env_args names the
/// robot (there is no simulator to create one in), the controller's rate and the order of joints
/// and tips. Throws InputError for a joint without finite limits.
RobomimicHeader robomimic_header(const RobotModel& robot, double rate_hz);

/// Converts an executable plan with T samples to T - 1 transitions: the action at a sample is the
/// position at the next one. Observations, positions in the base frame [m, rad]:
///   joint_positions, joint_velocities [n]   tip_positions [3 m] tip by tip
///   palm_position [3]  palm_orientation [4] (w, x, y, z)   demonstration_phase [7], one-hot
///   with `target`: target_position [3]  target_orientation [4], pose of the object at the grasp
RobomimicDemo robomimic_demo(const RobotModel& robot, const Plan& plan, bool target);

}  // namespace morphe::exports
