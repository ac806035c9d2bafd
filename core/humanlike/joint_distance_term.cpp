#include "core/humanlike/joint_distance_term.hpp"

namespace morphe::humanlike {

void JointDistance::add(const RobotState& state, const FrameGoal& goal, double share,
                        Loads& loads) const {
  if (!is_known(goal.elbow)) return;
  const double weight_of_centre = share / static_cast<double>(state.robot.arm_centres.size());
  for (const int frame : state.robot.arm_centres)
    loads.add_point(frame, state.pose_of(frame).translation(), goal.elbow, weight_of_centre, false);
}

}  // namespace morphe::humanlike
