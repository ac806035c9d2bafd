#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::certify {

/// Returns the grasp in the frame of the movement's target, at the first sample of the first phase
/// `grasp` (the last sample if the trajectory ends before). The pregrasp posture is the one up to
/// there at which thumb and index tips are farthest apart; the first posture for a hand without
/// these tips. sample is -1 without a target, a phase `grasp` or a trajectory.
Grasp find_grasp(const RobotModel& robot, const Scene& scene, const Movement& movement,
                 const Trajectory& trajectory);

}  // namespace morphe::certify
