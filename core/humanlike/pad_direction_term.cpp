#include "core/humanlike/pad_direction_term.hpp"

namespace morphe::humanlike {

void PadDirection::add(const RobotState& state, const FrameGoal& goal, double share,
                       Loads& loads) const {
  for (int i = 0; i < std::ssize(goal.pad_normal); ++i) {
    const Vec3& normal = goal.pad_normal[i];
    const int frame = state.robot.tips[i].frame;
    if (!is_known(normal) || frame < 0) continue;
    const Vec3 direction = state.pose_of(frame).linear() * state.robot.pads[i].direction;
    loads.add_direction(frame, direction, normal, share * goal.tip_to_pad_share_of(i));
  }
}

}  // namespace morphe::humanlike
