#pragma once

#include <array>

#include "stages/simulate/rollout.hpp"

namespace morphe::simulate {

/// What a grasp must press with and what it is sent to press with, computed before anything is
/// simulated (docs/steps/simulate.md): newtons of the finger that presses most, the others in the
/// shares of the squeeze, and less where that balances better. With the friction, the mass and the
/// turn of a variation; infinite where no squeeze in these shares bears the weight.
struct Newtons {
  double worst = 0;  ///< for the target's weight in the worst direction [N]
  double down = 0;   ///< for its weight as it stands [N]
  /// For weight and acceleration as it is lifted, forces alone: what torques the fingers cannot
  /// bear it turns until they are gone, which counts as held up to kMotion_deg and kMotion_m [N].
  double lift = 0;
  std::array<double, 6> along{};  ///< for its weight along the target's -x, x, -y, y, -z, z [N]
  double given = 0;               ///< that the servos are sent to press with [N]
};

Newtons newtons_of(const PreparedPlan& plan, const Variation& variation);

}  // namespace morphe::simulate
