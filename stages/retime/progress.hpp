#pragma once

#include <Eigen/Core>

#include "pipeline/motion/robot_table.hpp"
#include "stages/retime/joint_spline.hpp"
#include "stages/retime/path_clock.hpp"

namespace morphe {

/// The path over a parameter w that is slow at its ends: u = g(w) with g' = 6z^2 - 8z^3 + 3z^4,
/// z = w / ramp, rising from 0 to 1 (the same backwards at the end), so that dq/dw and d2q/dw2
/// vanish there and any dw/dt starts and ends at rest in velocity and acceleration.
struct RampedPath {
  const JointSpline* spline = nullptr;
  double ramp = 0;    ///< [s]
  double length = 0;  ///< of w [s]
};
RampedPath ramp_ends(const JointSpline& spline, double ramp_s);

/// g and its first three derivatives.
struct ClockAt {
  double u = 0, d1 = 0, d2 = 0, d3 = 0;
};
ClockAt clock_at(const RampedPath& path, double w);
/// q and its first three derivatives by w, rows of out [4, n].
void evaluate(const RampedPath& path, double w, JointRows& out);

/// Progress along w: x = (dw/dt)^2 as a cubic B-spline on uniform knots, C^2, so that the jerk is
/// continuous.
struct Progress {
  double length = 1;            ///< of w
  Eigen::VectorXd coefficient;  ///< [intervals + 3], > 0
};
struct ProgressAt {
  double x = 0, d1 = 0, d2 = 0;  ///< x, dx/dw, d2x/dw2
};
ProgressAt evaluate(const Progress& progress, double w);

/// Minimises the duration, integral of x^(-1/2) dw, subject to
///   |q_w| x^(1/2) <= v,  |q_ww x + q_w x_w / 2| <= a,
///   |q_www x + 3/2 q_ww x_w + q_w x_ww / 2| x^(1/2) <= j,  u_w x^(1/2) <= tempo_cap * stretch(u),
/// with `share` of the robot's limits, at collocation points; what lies between may exceed them a
/// little. Log barrier, Newton on the banded system. The steady pace that is always feasible is
/// where it starts, so that every iterate is feasible.
Progress fastest_progress(const RobotTable& robot, const RampedPath& path,
                          const ClockedPath& clocked, double share, double tempo_cap,
                          double step_s);
/// The steady pace alone.
Progress steady_progress(const RobotTable& robot, const RampedPath& path,
                         const ClockedPath& clocked, double share, double tempo_cap, double step_s);

}  // namespace morphe
