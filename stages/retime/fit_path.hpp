#pragma once

#include <vector>

#include "core/math/joint_spline.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::retime {

/// What smoothing may do. A tolerance of zero leaves as much as keeps the spline from ringing
/// between the samples: 1e-5 m, 1e-5 rad.
struct FitTolerance {
  double duration_s = 0.02;  ///< features shorter than about this are smoothed away …
  double tip_m = 2e-4;       ///< … unless that moves a tip by more than this …
  double joint_rad = 1e-3;   ///< … or a joint that moves no tip
};

struct PathFit {
  math::JointSpline spline;
  double tip_deviation = 0;    ///< largest over tips and samples, 0 without tips [m]
  double joint_deviation = 0;  ///< largest over joints and samples [rad]
};

/// Minimises, over the coefficients of a quintic B-spline on knots at most `step_s` apart,
///   sum_i w_i |q(u_i) - y_i|^2 + sum (duration / step)^6 |third difference|^2
/// for all joints with the same weights w_i, raised wherever the tips (J(y_i) (q(u_i) - y_i)) or
/// the joints without tips are off by more than `allowance_i` times the tolerance, until none is;
/// after 30 rounds the step is halved, twice at most and only while that helps. The ends are met to
/// 2e-7 rad unless a limit is in the way. The curve stays within [lower, upper] everywhere: its
/// Bézier points do. clock [W] not decreasing, from 0; samples [W, n]; allowance [W].
PathFit fit_path(const RobotTable& robot, const std::vector<double>& clock,
                 const JointRows& samples, const std::vector<double>& allowance,
                 const FitTolerance& tolerance, double step_s);

}  // namespace morphe::retime
