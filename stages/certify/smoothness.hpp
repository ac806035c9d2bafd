#pragma once

#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::certify {

/// Speeds at equidistant instants [m/s].
struct SpeedProfile {
  std::vector<double> speed;
  double step_s = 0;  ///< between instants
};

/// Returns the speed of the robot's tips at t_k = k h: the mean of |x(t_k + h) - x(t_k - h)| / 2h
/// over the tips that have a goal in every frame. x is on the trajectory's quintics, h the step of
/// the goals' clock. The profile is empty without such tips.
SpeedProfile robot_speed(const RobotModel& robot, const Goals& goals, const Trajectory& trajectory);
/// Returns the speed of the goals of the same tips, with the same h.
SpeedProfile human_speed(const Goals& goals);

/// Returns SPARC, Balasubramanian et al. 2012 and 2015 (10.1186/s12984-015-0090-9), dimensionless,
/// < 0, smoother if closer to 0: minus the length of the curve M(f) = |V(f)| / max |V|,
///   -sum_k sqrt((1 / (K - 1))² + (M_k+1 - M_k)²).
/// V is the Fourier transform of the speed, padded with zeros to 2^(ceil(log2 N) + 4) instants. The
/// K frequencies reach from 0 to the last one up to 10 Hz with M >= 0.05. NaN with fewer than three
/// instants, without motion, or if K < 2.
double spectral_arc_length(const SpeedProfile& profile);

/// Returns the log dimensionless jerk, Hogan and Sternad 2009 (10.3200/35-09-004-RC), with the
/// logarithm of Balasubramanian et al.:
///   -ln(D³ / v_peak² * integral of (d²v/dt²)² dt),
/// with D the profile's duration; -ln(720 / 1.875²) = -5.32 for a minimum-jerk reach. NaN with
/// fewer than three instants or without motion.
double log_dimensionless_jerk(const SpeedProfile& profile);

}  // namespace morphe::certify
