#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::certify {

/// The grasp in the frame of the movement's target, at the first sample of the first phase `grasp`
/// (the last sample if the trajectory ends before). The pregrasp posture is where thumb and index
/// tips are farthest apart up to there; the first posture for a hand without these tips. sample is
/// -1 without a target, a phase `grasp` or a trajectory.
Grasp find_grasp(const RobotTable& robot, const Scene& scene, const Movement& movement,
                 const Trajectory& trajectory);

}  // namespace morphe::certify
