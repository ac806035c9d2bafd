#pragma once

#include <array>

#include "stages/simulate/prepared_plan.hpp"

namespace morphe::simulate {

/// The forces that a grasp requires by statics, and the force that is commanded
/// (docs/steps/simulate.md). Each is the force of the finger that presses most; the other fingers
/// press in the proportions of the squeeze, or less if that balances better. A required force is
/// infinite if no such squeeze supports the load.
struct RequiredForces {
  double worst_N = 0;    ///< for the target's weight in the worst direction
  double gravity_N = 0;  ///< for its weight in its actual orientation
  /// for weight and acceleration during the lift, by the balance of forces without that of torques:
  /// a target whose torques are not supported turns until they vanish, which may count as held. For
  /// a target that is carried as planned, with the torques of loads that turn farther than that.
  double lift_N = 0;
  std::array<double, 6> along_axes_N{};  ///< for its weight along the target's -x, x, -y, y, -z, z
  double commanded_N = 0;                ///< force of the squeeze within the motors' limits
};

/// Computes the forces for a variation of a prepared plan.
RequiredForces required_forces(const PreparedPlan& plan, const Variation& variation);

}  // namespace morphe::simulate
