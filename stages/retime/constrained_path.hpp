#pragma once

#include <vector>

#include "core/math/joint_spline.hpp"
#include "core/motion/movement.hpp"
#include "stages/retime/path_parameter.hpp"
#include "stages/retime/reachability.hpp"

namespace morphe::retime {

/// A smooth path and the bounds of the path velocity du/dt along it, all of them positive and
/// possibly infinite.
struct ConstrainedPath {
  const RobotModel* robot = nullptr;
  const Movement* movement = nullptr;
  ParameterizedPath parameterized;
  math::JointSpline spline;
  JointVector velocity, acceleration, jerk;  ///< [n] permitted shares of the robot's limits
  double braking_share = 1;                  ///< permitted share of its braking curves
  /// greatest nominal path velocity [path parameter s per s]
  double nominal_path_velocity = kMaxPathVelocity;
  double end_speedup = 0;  ///< share by which the nominal path velocity is increased at both ends …
  double end_speedup_s = 0.3;  ///< … falling smoothly to 0 this far from them [s]
  /// Share by which the nominal path velocity is increased, over equal cells of the path parameter;
  /// empty if it is not increased.
  std::vector<double> speedup;
  double tip_speed = kMaxPathVelocity;  ///< limit of the speed of any tip [m/s]
  /// scale of nominal path velocity, joint speed and tip speed, by index of PhaseKind
  std::vector<double> phase_scale;
  /// Slowdown over equal cells of the path parameter: the limits are those of a motion slower by
  /// this factor.
  std::vector<double> slowdown;
};

/// Returns the slowdown s at a path parameter, for which the limits are v / s, a / s^2, j / s^3.
double slowdown_at(const ConstrainedPath& paced_path, double u);

/// Returns the largest du/dt that the speed limits and the nominal path velocity allow at path
/// parameter u; the rows of q are the path's derivatives there.
double max_path_velocity(const ConstrainedPath& paced_path, double u, const JointRows& q);

/// Evaluates the path on `steps` equal steps for the reachability analysis.
PathGrid path_grid(const ConstrainedPath& paced_path, Eigen::Index steps);

}  // namespace morphe::retime
