#include "core/humanlike/palm_direction_term.hpp"

namespace morphe::humanlike {

void PalmDirection::add(const RobotState& state, const FrameGoal& goal, double share,
                        Loads& loads) const {
  const int palm = state.robot.palm_frame;
  if (!is_known(goal.hand) || palm < 0) return;
  const Eigen::Matrix3d human = goal.hand.toRotationMatrix();
  for (const int axis : {2, 1}) {
    const Vec3 direction = state.pose_of(palm).linear().col(axis);
    loads.add_direction(palm, direction, human.col(axis), share);
  }
}

}  // namespace morphe::humanlike
