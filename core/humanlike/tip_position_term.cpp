#include "core/humanlike/tip_position_term.hpp"

namespace morphe::humanlike {

void TipPosition::add(const RobotState& state, const FrameGoal& goal, double share,
                      Loads& loads) const {
  for (int i = 0; i < std::ssize(state.robot.tips); ++i) {
    if (!is_known(goal.tip_position[i])) continue;
    const Vec3 point =
        robot::tracked_point(state.robot, state.base_from_frame, i, goal.tip_to_pad_share_of(i));
    loads.add_point(state.robot.tips[i].frame, point, goal.tip_position[i], share, true);
  }
}

}  // namespace morphe::humanlike
