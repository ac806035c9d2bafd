#include "core/humanlike/finger_joint_distance_term.hpp"

#include <cmath>

namespace morphe::humanlike {

void FingerJointDistance::add(const RobotState& state, const FrameGoal& goal, double share,
                              Loads& loads) const {
  const robot::Robot& robot = state.robot;
  for (int j = 0; j < std::ssize(robot.joint_centres); ++j) {
    const int i = robot.tip_of_centre[j];
    if (i < 0) continue;
    Vec3 joint = unknown_point();
    if (!std::isfinite(robot.tips[i].finger_curve_share)) {
      joint = goal.finger_joint[robot.tips[i].finger];
    } else if (i < std::ssize(goal.interpolated_finger_joint)) {
      joint = goal.interpolated_finger_joint[i];
    }
    if (!is_known(joint)) continue;
    const int frame = robot.joint_centres[j].frame;
    loads.add_point(frame, state.pose_of(frame).translation(), joint,
                    share / robot.chain_centre_count[j], false);
  }
}

}  // namespace morphe::humanlike
