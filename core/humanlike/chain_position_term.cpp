#include "core/humanlike/chain_position_term.hpp"

#include "core/humanlike/arm_chain.hpp"

namespace morphe::humanlike {

void ChainPosition::add(const RobotState& state, const FrameGoal& goal, double share,
                        Loads& loads) const {
  if (goal.chain.empty()) return;
  const ArmChain arm = arm_chain(state.robot, state.base_from_frame);
  for (int i = 1; i < std::ssize(arm.joints); ++i) {
    if (!is_known(goal.chain[i])) continue;
    loads.add_point(arm.frames[i], arm.joints[i], goal.chain[i], share, true);
  }
}

}  // namespace morphe::humanlike
