#include "core/humanlike/thumb_distance_term.hpp"

#include <algorithm>

#include "core/motion/human_motion.hpp"
#include "core/robot/forward_kinematics.hpp"

namespace morphe::humanlike {
namespace {

/// Adds the gradient of the distance of two points with respect to the joints; `away` is the unit
/// vector to the first. Contributions of joints that move both points cancel.
void add_distance_gradient(const RobotState& state, const RobotModel::Tip& tip, const Vec3& point,
                           const Vec3& away, JointVector& slope) {
  robot::add_point_gradient(state.robot, state.base_from_frame, tip.frame, -1, point, away, slope);
}

}  // namespace

double ThumbDistance::proximity_weight(double distance_m) const {
  const double u =
      std::clamp((distance_m - full_distance_m) / (zero_distance_m - full_distance_m), 0.0, 1.0);
  return 1 - u * u * (3 - 2 * u);
}

void ThumbDistance::add(const RobotState& state, const FrameGoal& goal, double share,
                        solve::Quadratic& model) const {
  const std::vector<RobotModel::Tip>& tips = state.robot.tips;
  const auto is_thumb = [](const RobotModel::Tip& tip) {
    return tip.finger == static_cast<int>(kThumb);
  };
  const auto position_of = [&](std::size_t tip) -> Vec3 {
    return robot::tip_pose(state.robot, state.base_from_frame, tip).translation();
  };
  const auto thumb = std::ranges::find_if(tips, is_thumb);
  if (thumb == tips.end()) return;
  const auto first = static_cast<std::size_t>(thumb - tips.begin());
  const Vec3& thumb_goal = goal.tip_position[first];
  if (!is_known(thumb_goal)) return;
  const Vec3 thumb_at = position_of(first);
  JointVector slope(state.q.size());
  for (std::size_t i = 0; i < tips.size(); ++i) {
    if (tips[i].finger <= static_cast<int>(kThumb) || !is_known(goal.tip_position[i])) continue;
    const double wanted = (thumb_goal - goal.tip_position[i]).norm() / goal.hand_scale;
    const double weighted = share * proximity_weight(wanted);
    if (weighted == 0) continue;
    const Vec3 at = position_of(i), apart = thumb_at - at;
    const double distance = apart.norm();
    if (!(distance > 0)) continue;  // coincident points define no direction
    slope.setZero();
    add_distance_gradient(state, *thumb, thumb_at, apart / distance, slope);
    add_distance_gradient(state, tips[i], at, -apart / distance, slope);
    const double off = distance - wanted;
    model.value += weighted * off * off;
    model.gradient.head(slope.size()) += 2 * weighted * off * slope;
    model.hessian.topLeftCorner(slope.size(), slope.size()).noalias() +=
        2 * weighted * slope * slope.transpose();
  }
}

}  // namespace morphe::humanlike
