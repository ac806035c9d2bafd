#include "core/humanlike/triangle_area_term.hpp"

#include "core/humanlike/arm_chain.hpp"

namespace morphe::humanlike {

void TriangleArea::add(const RobotState& state, const FrameGoal& goal, double share,
                       Loads& loads) const {
  if (!goal.has_arm_goal()) return;
  const Chain human{goal.shoulder, goal.elbow, goal.wrist};
  const ArmChain arm = arm_chain(state.robot, state.base_from_frame);
  if (arm.joints.size() < 2) return;  // a hand without an arm
  add_chain(triangle_area_gradient(human, arm.joints, smoothing_m2), arm, share, loads);
}

}  // namespace morphe::humanlike
