#include "core/humanlike/tip_orientation_term.hpp"

namespace morphe::humanlike {

void TipOrientation::add(const RobotState& state, const FrameGoal& goal, double share,
                         Loads& loads) const {
  for (int i = 0; i < std::ssize(state.robot.tips); ++i) {
    if (!is_known(goal.tip_orientation[i])) continue;
    const RobotModel::Tip& tip = state.robot.tips[i];
    const Quat in_frame(tip.transform.linear());
    const Quat current =
        tip.frame < 0 ? in_frame : Quat(state.pose_of(tip.frame).linear()) * in_frame;
    loads.add_angle(tip.frame, current, goal.tip_orientation[i], share, smoothing_rad);
  }
}

}  // namespace morphe::humanlike
