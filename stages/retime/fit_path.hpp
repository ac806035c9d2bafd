#pragma once

#include <vector>

#include "core/math/joint_spline.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::retime {

/// The tolerances of smoothing. Smaller ones than kMinTolerance are raised to it, lest the spline
/// oscillates between samples.
struct FitTolerance {
  double duration_s = 0.02;  ///< features shorter than about this are smoothed [s] …
  double tip_m = 2e-4;       ///< … unless that moves a tip by more than this [m] …
  double joint_rad = 1e-3;   ///< … or a joint that moves no tip by more than this [rad]
};

/// A spline fitted to a path, and its deviations.
struct PathFit {
  math::JointSpline spline;
  double tip_deviation = 0;    ///< largest over tips and samples, 0 if there are no tips [m]
  double joint_deviation = 0;  ///< largest over joints and samples [rad]
};

/// Fits a quintic B-spline q(u) with knots at most `step_s` apart to samples y_i at u_i by
/// minimising
///   sum_i w_i |q(u_i) - y_i|^2 + sum (duration / step)^6 |third difference|^2
/// over its coefficients, for all joints with the same weights w_i. A weight is raised while a tip
/// (J(y_i) (q(u_i) - y_i)) or a joint that moves no tip deviates by more than allowance_i times the
/// tolerance. If that is so after 30 rounds, the step is halved, at most twice and only while it
/// helps. The ends are met to 2e-7 rad unless a limit prevents it. The curve stays within the joint
/// limits everywhere, because its Bézier points do. `clock` has the u_i [W], nondecreasing from 0;
/// `samples` the y_i [W, n]; `allowance` factors [W] on duration and tolerances.
PathFit fit_path(const RobotModel& robot, const std::vector<double>& clock,
                 const JointRows& samples, const std::vector<double>& allowance,
                 const FitTolerance& requested, double step_s);

}  // namespace morphe::retime
