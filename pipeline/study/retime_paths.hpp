#pragma once

#include <cstdint>

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::study {

/// A random robot without tips and a path for it: 1 to 44 joints with limits over two decades (the
/// jerk's sometimes infinite, the positions' sometimes exactly the path's range), 2 to 2,000
/// waypoints; smooth, with noise, with reversals, from waypoint to waypoint in straight lines; with
/// joints that stand still, pauses, repeated waypoints and planned stretches.
struct RandomPath {
  RobotTable robot;
  JointPath path;
  double sample_rate_hz = 500;
};
RandomPath random_path(std::uint64_t seed, std::uint64_t index);

/// The same of 1 to 4 joints and 2 to 12 waypoints, sampled at 50 to 500 Hz.
RandomPath small_path(std::uint64_t seed, std::uint64_t index);

/// A smooth random path of sines without any of that, through `waypoints` points in `duration_s`.
RandomPath smooth_path(std::uint64_t seed, std::uint64_t index, int joints, int waypoints,
                       double duration_s);

/// What a controller would see of a trajectory: the quintic's largest share of each limit at 16
/// points between samples, from derivatives of its own.
struct SeenLimits {
  double velocity = 0, acceleration = 0, jerk = 0;
  double beyond = 0;     ///< of the position limits, <= 0: none [rad]
  bool at_rest = false;  ///< both ends, velocity and acceleration exactly zero
  bool time_increases = false;
};
SeenLimits seen_limits(const RobotTable& robot, const Trajectory& trajectory);

}  // namespace morphe::study
