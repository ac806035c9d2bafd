#pragma once

#include <vector>

#include "core/motion/robot_table.hpp"
#include "stages/verify/curve.hpp"

namespace morphe::verify {

/// Mean speed of the tips that every frame has a goal for, at the instants k h between the first
/// and the last, h the mean step of the goals' clock: |x(t + h) - x(t - h)| / 2h [m/s].
struct Speeds {
  std::vector<double> robot;  ///< on the trajectory's own clock
  std::vector<double> human;
  double step_s = 0;
};
Speeds mean_speeds(const RobotTable& robot, const Goals& goals, const Curve& curve);

/// Minus the arc length of the speed's magnitude spectrum (over its greatest value, from 0 Hz to
/// the last frequency up to 10 Hz where it is 0.05, frequency scaled to that), of 16 times the
/// least power of two not below the number of instants. NaN without motion or with fewer than three
/// instants.
double sparc(const std::vector<double>& speed, double step_s);

/// -ln(duration^3 / peak^2 * integral of the speed's squared second derivative), likewise.
double log_dimensionless_jerk(const std::vector<double>& speed, double step_s);

}  // namespace morphe::verify
