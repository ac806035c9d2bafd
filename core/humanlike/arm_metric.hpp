#pragma once

#include "core/humanlike/arm_chain.hpp"
#include "core/humanlike/chain_gradients.hpp"
#include "core/humanlike/term.hpp"

namespace morphe::humanlike {

/// Adds to the loads `share` times metric_of(human chain, robot chain). Adds 0 without an arm goal,
/// or for a hand without an arm.
template <class Metric>
void add_arm_metric(const RobotState& state, const FrameGoal& goal, double share,
                    const Metric& metric_of, Loads& loads) {
  if (!goal.has_arm_goal()) return;
  const ArmChain arm = arm_chain(state.robot, state.base_from_frame);
  if (arm.joints.size() < 2) return;
  const ChainGradient metric = metric_of({goal.shoulder, goal.elbow, goal.wrist}, arm.joints);
  loads.value += share * metric.value;
  for (int i = 0; i < std::ssize(arm.joints); ++i) {
    const Vec3 force = share * metric.gradient[i];
    loads.add_force(arm.frames[i], arm.joints[i], force, force, share * metric.curvature[i]);
  }
}

}  // namespace morphe::humanlike
