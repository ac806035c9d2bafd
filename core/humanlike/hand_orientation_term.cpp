#include "core/humanlike/hand_orientation_term.hpp"

namespace morphe::humanlike {

void HandOrientation::add(const RobotState& state, const FrameGoal& goal, double share,
                          Loads& loads) const {
  if (!is_known(goal.hand) || goal.recorded_tip_count() >= 3) return;
  const int palm = state.robot.palm_frame;
  loads.add_angle(palm, Quat(state.pose_of(palm).linear()), goal.hand, share, smoothing_rad);
}

}  // namespace morphe::humanlike
