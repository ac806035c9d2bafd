#include "pipeline/humanlike/finger_joint_distance_term.hpp"

#include <cmath>

#include "pipeline/humanlike/centre_load.hpp"

namespace morphe::humanlike {
namespace {

/// The tip at the end of the finger that a centre belongs to; -1: the arm's, or no finger's.
int tip_beyond(const RobotTable& robot, const RobotTable::Centre& centre) {
  if (centre.chain == "arm") return -1;
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    if (robot.tips[tip].finger < 0) continue;
    int frame = robot.tips[tip].frame;  // parents come first
    while (frame > centre.frame) frame = robot.frames[static_cast<std::size_t>(frame)].parent;
    if (frame == centre.frame) return static_cast<int>(tip);
  }
  return -1;
}

}  // namespace

void FingerJointDistance::add(const RobotState& state, const FrameGoal& goal, double share,
                              Loads& loads) const {
  for (const RobotTable::Centre& centre : state.robot.centres) {
    const int beyond = tip_beyond(state.robot, centre);
    if (beyond < 0) continue;
    const auto i = static_cast<std::size_t>(beyond);
    const RobotTable::Tip& tip = state.robot.tips[i];
    if (!std::isfinite(tip.along)) {
      add_centre(state, centre, goal.finger_joint[static_cast<std::size_t>(tip.finger)], share,
                 loads);
    } else if (i < goal.curve_joint.size()) {
      add_centre(state, centre, goal.curve_joint[i], share, loads);
    }
  }
}

}  // namespace morphe::humanlike
