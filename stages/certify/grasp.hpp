#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::certify {

/// Returns the grasp in the frame of the movement's target, at the first sample of the first phase
/// `grasp`, or at the last sample if the trajectory ends before. The pregrasp posture is the one up
/// to that sample at which thumb and index tips are farthest apart, or the first one for a hand
/// without these tips. Without a target, a phase `grasp` or a trajectory, `sample` is -1.
Grasp find_grasp(const RobotModel& robot, const Scene& scene, const Movement& movement,
                 const Trajectory& trajectory);

}  // namespace morphe::certify
