#pragma once

#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::certify {

/// Speed at equal instants [m/s].
struct SpeedProfile {
  std::vector<double> speed;
  double step_s = 0;
};

/// Mean over the tips that have a goal in every frame of
///   |x(t_k + h) - x(t_k - h)| / 2h,  t_k = k h,
/// h the step of the goals' clock, for both alike: of the robot on the trajectory's own clock (the
/// quintic between samples), of the human at the goals. Empty if no tip has a goal in every frame.
SpeedProfile robot_speed(const RobotTable& robot, const Goals& goals, const Trajectory& trajectory);
SpeedProfile human_speed(const Goals& goals);

/// SPARC, Balasubramanian et al. 2012 and 2015 (10.1186/s12984-015-0090-9), no unit, < 0, smoother
/// if nearer to 0: minus the length of the curve M(f) = |V(f)| / max |V|, 0 <= f <= f_c,
///   -sum_k sqrt((1 / (K - 1))² + (M_k+1 - M_k)²)
/// V the Fourier transform of the speed padded with zeros to 2^(ceil(log2 N) + 4) instants, over
/// the K frequencies from the first to the last with M >= 0.05 up to 10 Hz. NaN with fewer than
/// three instants, without motion, or if K < 2.
double spectral_arc_length(const SpeedProfile& profile);

/// Log dimensionless jerk, Hogan and Sternad 2009 (10.3200/35-09-004-RC) as Balasubramanian et al.
/// take its logarithm:
///   -ln(D³ / v_peak² * integral of (d²v/dt²)² dt),
/// D the duration of the profile. A minimum-jerk reach has -ln(720 / 1.875²) = -5.32. NaN with
/// fewer than three instants or without motion.
double log_dimensionless_jerk(const SpeedProfile& profile);

}  // namespace morphe::certify
