#pragma once

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"

namespace morphe::study {

/// Counts the states of a trajectory, from its first to its last sample, that FCL alone finds in
/// collision in the scene of a plan, at a required clearance of 0. From one state to the next, no
/// capsule of the robot moves farther than `step_m`; objects may.
int count_colliding_states(const robot::Robot& robot, const Plan& plan,
                           const Trajectory& trajectory, double step_m);

}  // namespace morphe::study
