#pragma once

#include <cstdint>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::study {

/// A random robot without tips, and a path for it. The robot has 1 to 44 joints with limits over
/// two decades. Jerk limits are sometimes infinite, position limits sometimes exactly the range of
/// the path. The path has 2 to 2,000 waypoints: random ones, or smooth waves, some of them with
/// noise, reversals, constant joints, pauses, waypoints repeated at the same time, and planned
/// sections.
struct RandomPath {
  RobotModel robot;
  JointPath path;
  double sample_rate_hz = 500;  ///< of the trajectory
};
/// Generates path number `index`.
RandomPath random_path(std::uint64_t seed, std::uint64_t index);

/// Generates a similar path with 1 to 4 joints and 2 to 12 waypoints, sampled at 50 to 500 Hz.
RandomPath short_path(std::uint64_t seed, std::uint64_t index);

/// Generates a path of random sines without these irregularities.
RandomPath smooth_path(std::uint64_t seed, std::uint64_t index, int joints, int waypoints,
                       double duration_s);

/// The use of the limits by a trajectory as a controller executes it: the largest share of each
/// limit that the quintics between samples reach, each evaluated at 17 points including its ends.
struct LimitUsage {
  double velocity = 0, acceleration = 0, jerk = 0;
  double position_excess = 0;   ///< beyond the position limits, <= 0 if they are respected [rad]
  bool at_rest = false;         ///< velocity and acceleration are exactly zero at both ends
  bool time_increases = false;  ///< strictly
};
/// Computes the use of the limits, with other code than retiming and certificate.
LimitUsage measure_limit_usage(const RobotModel& robot, const Trajectory& trajectory);

}  // namespace morphe::study
