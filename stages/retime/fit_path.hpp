#pragma once

#include <vector>

#include "core/math/joint_spline.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::retime {

/// The tolerances of smoothing. A tolerance of zero still permits 1e-5 m and 1e-5 rad, enough to
/// keep the spline from oscillating between the samples.
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

/// Fits a quintic B-spline with knots at most `step_s` apart to the samples by minimising
///   sum_i w_i |q(u_i) - y_i|^2 + sum (duration / step)^6 |third difference|^2
/// over its coefficients, for all joints with the same weights w_i. The weights are raised wherever
/// the tips (J(y_i) (q(u_i) - y_i)) or the joints without tips deviate by more than `allowance_i`
/// times the tolerance, until no deviation exceeds it; after 30 rounds the step is halved, at most
/// twice and only while that helps. The ends are met to 2e-7 rad unless a limit prevents it. The
/// curve stays within [lower, upper] everywhere, because its Bézier points do. clock [W]
/// nondecreasing from 0; samples [W, n]; allowance [W].
PathFit fit_path(const RobotModel& robot, const std::vector<double>& clock,
                 const JointRows& samples, const std::vector<double>& allowance,
                 const FitTolerance& tolerance, double step_s);

}  // namespace morphe::retime
