#include "pipeline/humanlike/joint_distance_term.hpp"

#include <cmath>

#include "pipeline/humanlike/centre_load.hpp"

namespace morphe::humanlike {

void JointDistance::add(const RobotState& state, const FrameGoal& goal, double share,
                        Loads& loads) const {
  if (!seen(goal.elbow)) return;
  for (const RobotTable::Centre& centre : state.robot.centres) {
    if (centre.chain == "arm") add_centre(state, centre, goal.elbow, share, loads);
  }
}

}  // namespace morphe::humanlike
