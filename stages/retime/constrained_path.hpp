#pragma once

#include <map>
#include <vector>

#include "core/math/joint_spline.hpp"
#include "core/motion/movement.hpp"
#include "stages/retime/constants.hpp"
#include "stages/retime/path_parameter.hpp"
#include "stages/retime/reachability.hpp"

namespace morphe::retime {

/// A smooth path and the bounds of du/dt along it, positive and possibly infinite.
struct ConstrainedPath {
  const RobotModel* robot = nullptr;
  const Movement* movement = nullptr;
  ParameterizedPath parameterized;
  math::JointSpline spline;
  JointVector velocity, acceleration, jerk;         ///< [n] permitted shares of the robot's limits
  double braking_share = 1;                         ///< permitted share of its braking curves
  double nominal_path_velocity = kMaxPathVelocity;  ///< bound of du/dt [path parameter s per s]
  double end_speedup = 0;  ///< share by which the nominal path velocity is increased at both ends …
  double end_speedup_s = 0.3;   ///< … falling smoothly to 0 this far from them [s]
  std::vector<double> speedup;  ///< such shares over equal cells of the path parameter, or empty
  double tip_speed = kMaxPathVelocity;      ///< limit of the speed of any tip [m/s]
  std::map<PhaseKind, double> phase_scale;  ///< factors on max_path_velocity() during phases
  std::vector<double> slowdown;  ///< [cells] of slowdown_at(), over equal cells of the parameter
};

/// Returns the slowdown s at a path parameter u, which reduces the limits to v / s, a / s^2, j /
/// s^3.
double slowdown_at(const ConstrainedPath& path, double u);

/// Returns the largest du/dt that is allowed at u. Rows 0 and 1 of q are the path and its
/// derivative.
double max_path_velocity(const ConstrainedPath& path, double u, const JointRows& q);

/// Evaluates the path on `steps` equal steps for the reachability analysis.
PathGrid path_grid(const ConstrainedPath& path, Eigen::Index steps);

}  // namespace morphe::retime
