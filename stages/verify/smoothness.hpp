#pragma once

#include <vector>

#include "core/motion/robot_model.hpp"
#include "stages/verify/curve.hpp"

namespace morphe::verify {

/// Mean speeds |x(t + h) - x(t - h)| / 2h of the tips that have a goal in every frame [m/s]. The
/// instants t are the multiples of h, the mean step between goal frames, between first and last.
struct Speeds {
  std::vector<double> robot;  ///< on the trajectory's own clock
  std::vector<double> human;  ///< on the goals' clock
  double step_s = 0;          ///< h
};
/// Computes the mean speeds of the robot's and the human's tips.
Speeds mean_speeds(const RobotModel& robot, const Goals& goals, const Curve& curve);

/// Computes the spectral arc length: minus the arc length of the speed's magnitude spectrum over
/// the frequency, from 0 Hz to the last frequency up to 10 Hz at which the spectrum is at least
/// 0.05 of its greatest value. Frequency and magnitude are normalised by their greatest values. The
/// spectrum has 16 times the least power of two that is not below the number of instants. NaN
/// without motion or with fewer than three instants.
double sparc(const std::vector<double>& speed, double step_s);

/// Computes -ln(duration^3 / peak speed^2 * integral of (d^2 speed / dt^2)^2). NaN without motion
/// or with fewer than three instants.
double log_dimensionless_jerk(const std::vector<double>& speed, double step_s);

}  // namespace morphe::verify
