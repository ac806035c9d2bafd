#pragma once

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"

namespace morphe::certify {

/// A wrist that never moves faster [m/s] has no speed profile: rounding alone would decide.
constexpr double kMinWristSpeed_m_s = 1e-3;

/// Returns Pearson's correlation of the robot's and the person's wrist speed,
///   robot_k = |x(t_k+1) - x(t_k-1)| / (t_k+1 - t_k-1),
///   human_k = |w_k+1 - w_k-1| / (d_k+1 - d_k-1),
/// over the frames k of the goals, without the first and the last. d_k is the frame's demonstration
/// time and w_k the person's wrist; t_k is the first time at which the trajectory reaches d_k (its
/// demonstration time is linear between samples), and x the robot's wrist on the quintics. A
/// constant slowdown does not change it, a pause does. Frames next to an unknown wrist do not
/// count. NaN for a robot without an arm, with fewer than two frames, or if one of the two never
/// moves faster than kMinWristSpeed_m_s.
double wrist_speed_correlation(const robot::Robot& robot, const Goals& goals,
                               const Trajectory& trajectory);

}  // namespace morphe::certify
