#include "pipeline/humanlike/tip_position_term.hpp"

namespace morphe::humanlike {
namespace {

Vec3 position_of(const RobotState& state, const RobotTable::Tip& tip) {
  if (tip.frame < 0) return tip.transform.translation();
  const Pose& pose = state.pose_of(tip.frame);
  return pose.linear() * tip.transform.translation() + pose.translation();
}

}  // namespace

void TipPosition::add(const RobotState& state, const FrameGoal& goal, double share,
                      Loads& loads) const {
  for (std::size_t i = 0; i < state.robot.tips.size(); ++i) {
    if (!seen(goal.tip_position[i])) continue;
    const RobotTable::Tip& tip = state.robot.tips[i];
    loads.add_point(tip.frame, position_of(state, tip), goal.tip_position[i], share, true);
  }
}

}  // namespace morphe::humanlike
