#include "core/humanlike/finger_joint_distance_term.hpp"

#include <cmath>

namespace morphe::humanlike {

void FingerJointDistance::add(const RobotState& state, const FrameGoal& goal, double share,
                              Loads& loads) const {
  const robot::Robot& robot = state.robot;
  for (std::size_t j = 0; j < robot.joint_centres.size(); ++j) {
    if (robot.tip_of_centre[j] < 0) continue;
    const auto i = static_cast<std::size_t>(robot.tip_of_centre[j]);
    const RobotModel::Tip& tip = robot.tips[i];
    Vec3 joint = unknown_point();
    if (!std::isfinite(tip.finger_curve_share))
      joint = goal.finger_joint[tip.finger];
    else if (i < goal.interpolated_finger_joint.size())
      joint = goal.interpolated_finger_joint[i];
    if (!is_known(joint)) continue;
    const int frame = robot.joint_centres[j].frame;
    loads.add_point(frame, state.pose_of(frame).translation(), joint,
                    share / robot.chain_centre_count[j], false);
  }
}

}  // namespace morphe::humanlike
