#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/motion/plan.hpp"
#include "stages/verify/quintic.hpp"

namespace morphe::verify {

/// A trajectory as a controller runs it: a quintic per joint between each two samples.
struct Curve {
  const Trajectory* trajectory = nullptr;
  std::size_t joints = 0, pieces = 0;
  std::vector<Quintic> quintics;             ///< [pieces * joints]
  std::vector<std::array<Range, 4>> ranges;  ///< [pieces * joints]
  JointRows speed;                           ///< [pieces, joints] greatest |velocity| [rad/s]

  double time_at(std::size_t piece, double s) const;
  double demonstration_time_at(std::size_t piece, double s) const;  ///< linear between samples
  void position_at(std::size_t piece, double s, JointVector& q) const;
};

/// The trajectory must outlive the curve, have at least one sample, fitting shapes and a strictly
/// increasing time.
Curve make_curve(const Trajectory& trajectory);

}  // namespace morphe::verify
