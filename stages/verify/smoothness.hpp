#pragma once

#include <vector>

#include "core/motion/robot_model.hpp"
#include "stages/verify/curve.hpp"

namespace morphe::verify {

/// Mean speeds of the tips that have a goal in every frame, at the instants k h between the first
/// and the last, with h the mean step of the goals' clock: |x(t + h) - x(t - h)| / 2h [m/s].
struct Speeds {
  std::vector<double> robot;  ///< on the trajectory's own clock
  std::vector<double> human;  ///< on the goals' clock
  double step_s = 0;          ///< h
};
/// Computes the mean speeds of the robot's and the human's tips.
Speeds mean_speeds(const RobotModel& robot, const Goals& goals, const Curve& curve);

/// Computes the spectral arc length: minus the arc length of the speed's magnitude spectrum,
/// normalised by its greatest value, from 0 Hz to the last frequency up to 10 Hz at which it is
/// 0.05, with the frequency normalised by that one. The spectrum has 16 times the least power of
/// two that is not below the number of instants. NaN without motion or with fewer than three
/// instants.
double sparc(const std::vector<double>& speed, double step_s);

/// Computes -ln(duration^3 / peak^2 * integral of the speed's squared second derivative). NaN in
/// the same cases.
double log_dimensionless_jerk(const std::vector<double>& speed, double step_s);

}  // namespace morphe::verify
