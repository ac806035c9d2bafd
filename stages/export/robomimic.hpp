#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/export/robomimic_file.hpp"

namespace morphe::exports {

/// Returns the header of a file whose actions are joint positions, scaled by the joint limits, at
/// `rate_hz`. env_args names the robot, the rate and the order of joints and tips; robomimic cannot
/// create an environment from it. Throws InputError for a joint without finite limits.
RobomimicHeader robomimic_header(const RobotModel& robot, double rate_hz,
                                 const std::string& not_verified);

/// Converts a plan with a trajectory of T > 1 samples to T - 1 transitions: the action at a sample
/// is the posture at the next one. The observations are, with poses in the base frame [m, rad],
///   joint_positions, joint_velocities [n]
///   tip_positions [3 · number of tips], tip by tip
///   palm_position [3], palm_orientation [4] (w, x, y, z)
///   demonstration_phase [7], one-hot
///   with `target`: target_position [3], target_orientation [4], pose of the object at the grasp
RobomimicDemo robomimic_demo(const RobotModel& robot, const Plan& plan, bool target);

}  // namespace morphe::exports
