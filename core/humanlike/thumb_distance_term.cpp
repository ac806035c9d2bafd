#include "core/humanlike/thumb_distance_term.hpp"

#include <algorithm>

#include "core/motion/human_motion.hpp"
#include "core/robot/forward_kinematics.hpp"

namespace morphe::humanlike {

double ThumbDistance::proximity_weight(double distance_m) const {
  const double u =
      std::clamp((distance_m - full_distance_m) / (zero_distance_m - full_distance_m), 0.0, 1.0);
  return 1 - u * u * (3 - 2 * u);
}

void ThumbDistance::add(const RobotState& state, const FrameGoal& goal, double share,
                        solve::Quadratic& model) const {
  const std::vector<RobotModel::Tip>& tips = state.robot.tips;
  const auto position_of = [&](std::ptrdiff_t tip) -> Vec3 {
    return robot::tip_pose(state.robot, state.base_from_frame, tip).translation();
  };
  // Gradient of the tips' distance; the contributions of joints that move both tips cancel.
  JointVector slope(state.q.size());
  const auto add_to_slope = [&](const RobotModel::Tip& tip, const Vec3& point, const Vec3& away) {
    robot::add_point_gradient(state.robot, state.base_from_frame, tip.frame, -1, point, away,
                              slope);
  };
  const auto thumb = std::ranges::find(tips, kThumb, &RobotModel::Tip::finger);
  if (thumb == tips.end()) return;
  const Vec3& thumb_goal = goal.tip_position[thumb - tips.begin()];
  if (!is_known(thumb_goal)) return;
  const Vec3 thumb_position = position_of(thumb - tips.begin());
  for (int i = 0; i < std::ssize(tips); ++i) {
    if (tips[i].finger <= thumb->finger || !is_known(goal.tip_position[i])) continue;
    const double human_distance = (thumb_goal - goal.tip_position[i]).norm() / goal.hand_scale;
    const double weighted = share * proximity_weight(human_distance);
    if (weighted == 0) continue;
    const Vec3 position = position_of(i), difference = thumb_position - position;
    const double distance = difference.norm();
    if (!(distance > 0)) continue;  // coincident points define no direction
    slope.setZero();
    add_to_slope(*thumb, thumb_position, difference / distance);
    add_to_slope(tips[i], position, -difference / distance);
    const double error = distance - human_distance;
    model.value += weighted * error * error;
    model.gradient.head(slope.size()) += 2 * weighted * error * slope;
    model.hessian.topLeftCorner(slope.size(), slope.size()).noalias() +=
        2 * weighted * slope * slope.transpose();
  }
}

}  // namespace morphe::humanlike
