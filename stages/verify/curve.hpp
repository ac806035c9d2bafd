#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/motion/plan.hpp"
#include "stages/verify/quintic.hpp"

namespace morphe::verify {

/// A trajectory as a controller executes it: one quintic per joint between any two consecutive
/// samples.
struct Curve {
  const Trajectory* trajectory = nullptr;
  std::size_t joints = 0, pieces = 0;        ///< numbers of joints and of sample intervals
  std::vector<Quintic> quintics;             ///< [pieces * joints]
  std::vector<std::array<Range, 4>> ranges;  ///< [pieces * joints]
  JointRows speed;                           ///< [pieces, joints] greatest |velocity| [rad/s]

  /// Returns the time on the trajectory's clock at `s` in [0, 1] of a piece [s].
  double time_at(std::size_t piece, double s) const;
  /// Returns the demonstration time at `s` of a piece [s], linear between samples.
  double demonstration_time_at(std::size_t piece, double s) const;
  /// Computes the joint positions at `s` of a piece.
  void position_at(std::size_t piece, double s, JointVector& q) const;
};

/// Builds the curve of a trajectory. The trajectory must outlive the curve, have at least one
/// sample, consistent shapes and strictly increasing time.
Curve make_curve(const Trajectory& trajectory);

}  // namespace morphe::verify
