#pragma once

#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::certify {

/// Speeds at equidistant instants [m/s].
struct SpeedProfile {
  std::vector<double> speed;
  double step_s = 0;  ///< time between instants [s]
};

/// Computes the mean over the tips that have a goal in every frame of
///   |x(t_k + h) - x(t_k - h)| / 2h,  t_k = k h,
/// with h the step of the goals' clock for both functions: of the robot on the trajectory's own
/// clock (the quintic between samples). Empty if no tip has a goal in every frame.
SpeedProfile robot_speed(const RobotModel& robot, const Goals& goals, const Trajectory& trajectory);
/// Computes the same for the human, at the goals.
SpeedProfile human_speed(const Goals& goals);

/// Computes SPARC, Balasubramanian et al. 2012 and 2015 (10.1186/s12984-015-0090-9), dimensionless,
/// < 0, smoother if closer to 0: minus the length of the curve M(f) = |V(f)| / max |V|,
/// 0 <= f <= f_c,
///   -sum_k sqrt((1 / (K - 1))² + (M_k+1 - M_k)²)
/// with V the Fourier transform of the speed padded with zeros to 2^(ceil(log2 N) + 4) instants,
/// over the K frequencies from the first to the last with M >= 0.05 up to 10 Hz. NaN with fewer
/// than three instants, without motion, or if K < 2.
double spectral_arc_length(const SpeedProfile& profile);

/// Computes the log dimensionless jerk, Hogan and Sternad 2009 (10.3200/35-09-004-RC), with the
/// logarithm of Balasubramanian et al.:
///   -ln(D³ / v_peak² * integral of (d²v/dt²)² dt),
/// with D the duration of the profile. A minimum-jerk reach has -ln(720 / 1.875²) = -5.32. NaN with
/// fewer than three instants or without motion.
double log_dimensionless_jerk(const SpeedProfile& profile);

}  // namespace morphe::certify
