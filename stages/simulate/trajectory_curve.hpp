#pragma once

#include "core/motion/plan.hpp"

namespace morphe::simulate {

/// Evaluates the quintics of a trajectory up to its sample `last`; the time must not decrease
/// between calls.
class TrajectoryCurve {
 public:
  TrajectoryCurve(const Trajectory& trajectory, Eigen::Index last)
      : trajectory_(trajectory), last_(last) {}

  /// Moves to a time since the trajectory's start; later than sample `last` counts as there.
  void move_to(double since_start_s);
  /// Returns the derivative of an order of all joints with respect to the trajectory's time.
  JointVector derivative(int order) const;

 private:
  const Trajectory& trajectory_;
  Eigen::Index last_, sample_ = 0;
  double since_sample_s_ = 0;
};

}  // namespace morphe::simulate
