#pragma once

#include <cstdint>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::study {

/// A random robot without tips and a path for it: 1 to 44 joints with limits over two decades (jerk
/// limits sometimes infinite, position limits sometimes exactly the range of the path), 2 to 2,000
/// waypoints; smooth, with noise, with reversals, or straight lines between waypoints; with
/// constant joints, pauses, repeated waypoints and planned sections.
struct RandomPath {
  /// The robot with its limits.
  RobotModel robot;
  /// The path of the robot.
  JointPath path;
  /// The sample rate of the trajectory [Hz].
  double sample_rate_hz = 500;
};
/// Generates path number `index`.
RandomPath random_path(std::uint64_t seed, std::uint64_t index);

/// Generates a similar path with 1 to 4 joints and 2 to 12 waypoints, sampled at 50 to 500 Hz.
RandomPath short_path(std::uint64_t seed, std::uint64_t index);

/// Generates a smooth random path of sines without these irregularities, through `waypoints` points
/// in `duration_s`.
RandomPath smooth_path(std::uint64_t seed, std::uint64_t index, int joints, int waypoints,
                       double duration_s);

/// The usage of the limits by a trajectory as a controller would see it: the largest share of each
/// limit that the quintic reaches at 16 points between samples, from independently computed
/// derivatives.
struct LimitUsage {
  /// The largest share of the velocity, acceleration and jerk limits.
  double velocity = 0, acceleration = 0, jerk = 0;
  /// Largest violation of the position limits, <= 0 if they are respected [rad].
  double position_excess = 0;
  /// True if velocity and acceleration are exactly zero at both ends.
  bool at_rest = false;
  /// True if the times are strictly increasing.
  bool time_increases = false;
};
/// Computes the usage of the limits.
LimitUsage measure_limit_usage(const RobotModel& robot, const Trajectory& trajectory);

}  // namespace morphe::study
