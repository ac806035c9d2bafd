#pragma once

#include <array>

#include "stages/simulate/rollout.hpp"

namespace morphe::simulate {

/// The forces that a grasp needs and the force that is commanded, computed before the simulation
/// (docs/steps/simulate.md): force of the finger that presses most, with the other fingers in the
/// proportions of the squeeze, or less for a finger if that balances better. They depend on the
/// friction, mass and orientation of a variation; infinite if no squeeze in these proportions
/// supports the weight.
struct PredictedForces {
  double worst_N = 0;    ///< for the target's weight in the worst direction [N]
  double gravity_N = 0;  ///< for its weight in its actual orientation [N]
  /// for weight and acceleration during the lift, considering forces only: torques that the fingers
  /// cannot support turn the target until they vanish, which counts as held up to
  /// kMaxInHandDisplacement_deg and kMaxInHandDisplacement_m [N]
  double lift_N = 0;
  std::array<double, 6>
      along_axes_N{};      ///< for its weight along the target's -x, x, -y, y, -z, z [N]
  double commanded_N = 0;  ///< commanded to the servos [N]
};

/// Computes the forces for a variation of a prepared plan.
PredictedForces predict_forces(const PreparedPlan& plan, const Variation& variation);

}  // namespace morphe::simulate
