#pragma once

#include <vector>

#include "core/math/joint_spline.hpp"
#include "core/motion/movement.hpp"
#include "stages/retime/path_clock.hpp"
#include "stages/retime/reachability.hpp"

namespace morphe::retime {

/// A smooth path and what bounds the pace du/dt along it, all of it positive and perhaps infinite.
struct PacedPath {
  const RobotTable* robot = nullptr;
  const Movement* movement = nullptr;
  ClockedPath clocked;
  math::JointSpline spline;
  JointVector velocity, acceleration, jerk;  ///< [n] shares of the robot's limits
  double braking_share = 1;                  ///< of its braking curves
  double tempo = kMostPace;                  ///< clock seconds per second at most
  double catch_up = 0;                       ///< tempo is greater by this share at both ends …
  double catch_up_s = 0.3;  ///< … falling smoothly to none this far from them [s]
  /// Over equal cells of the clock: tempo is greater by this share there. Empty: nowhere.
  std::vector<double> hurry;
  double tip_speed = kMostPace;     ///< of any tip [m/s]
  std::vector<double> phase_scale;  ///< of tempo, joint and tip speed, by number of PhaseKind
  /// Over equal cells of the clock: the limits are those of a motion this many times slower.
  std::vector<double> slowdown;
};

/// Limits at a clock time: v / s, a / s^2, j / s^3 with the slowdown s there.
double slowdown_at(const PacedPath& paced_path, double u);

/// The largest du/dt that speed limits and tempo allow where the path's derivatives are the rows of
/// q, at a clock time.
double most_pace(const PacedPath& paced_path, double u, const JointRows& q);

/// For the reachability analysis, on `steps` equal steps.
PaceGrid pace_grid(const PacedPath& paced_path, Eigen::Index steps);

}  // namespace morphe::retime
