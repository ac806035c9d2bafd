#pragma once

#include <array>
#include <vector>

#include "core/motion/plan.hpp"
#include "stages/verify/quintic.hpp"

namespace morphe::verify {

/// A place on a curve: sample k has step 2k, the piece after it has step 2k + 1.
struct CurvePoint {
  int step = 0;
  int sample = 0;     ///< nearest sample
  double time_s = 0;  ///< on the trajectory's clock
};

/// A trajectory as a controller executes it: one quintic per joint between consecutive samples.
struct Curve {
  const Trajectory* trajectory = nullptr;
  int pieces = 0;  ///< number of sample intervals
  Eigen::Index joints = 0;
  std::vector<Quintic> quintics;             ///< [pieces * joints]
  std::vector<std::array<Range, 4>> ranges;  ///< [pieces * joints] of derivatives 0 … 3
  JointRows speed;                           ///< [pieces, joints] greatest |velocity| [rad/s]

  /// Returns the place at `s` in [0, 1] of a piece.
  CurvePoint point_at(int piece, double s) const;
  /// Returns the demonstration time at `s` of a piece [s], linear between samples.
  double demonstration_time_at(int piece, double s) const;
  /// Computes the joint positions at `s` of a piece.
  void position_at(int piece, double s, JointVector& q) const;
};

/// Builds the curve of a trajectory. The trajectory must outlive the curve, have at least one
/// sample, consistent shapes and strictly increasing time.
Curve make_curve(const Trajectory& trajectory);

/// Returns the place of a sample.
CurvePoint point_at_sample(const Trajectory& trajectory, int sample);

}  // namespace morphe::verify
