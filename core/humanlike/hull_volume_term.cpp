#include "core/humanlike/hull_volume_term.hpp"

#include "core/humanlike/arm_chain.hpp"

namespace morphe::humanlike {

void HullVolume::add(const RobotState& state, const FrameGoal& goal, double share,
                     Loads& loads) const {
  if (!goal.has_arm_goal()) return;
  const Chain human{goal.shoulder, goal.elbow, goal.wrist};
  const ArmChain arm = arm_chain(state.robot, state.base_from_frame);
  if (arm.joints.size() < 2) return;  // a hand without an arm
  add_chain(hull_volume_gradient(human, arm.joints), arm, share, loads);
}

}  // namespace morphe::humanlike
