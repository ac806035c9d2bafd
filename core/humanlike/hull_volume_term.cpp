#include "core/humanlike/hull_volume_term.hpp"

#include "core/humanlike/arm_metric.hpp"
#include "core/humanlike/chain_gradients.hpp"

namespace morphe::humanlike {

void HullVolume::add(const RobotState& state, const FrameGoal& goal, double share,
                     Loads& loads) const {
  add_arm_metric(state, goal, share, hull_volume_gradient, loads);
}

}  // namespace morphe::humanlike
