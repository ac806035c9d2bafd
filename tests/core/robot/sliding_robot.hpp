#pragma once

#include "core/motion/robot_model.hpp"

namespace morphe::robot {

/// Joints that turn and slide, about and along slanted axes; frames coupled to either kind that
/// turn or slide themselves. The last frame carries the tip and a capsule.
inline RobotModel sliding_robot() {
  RobotModel robot;
  robot.name = "sliding";
  robot.joint_names = {"turn", "slide", "last"};
  robot.lower = JointVector::Constant(3, -0.3);
  robot.upper = JointVector::Constant(3, 0.4);
  robot.velocity = robot.acceleration = robot.jerk = JointVector::Ones(3);
  const auto add = [&](const Vec3& axis, int joint, double ratio, double offset, bool slides) {
    RobotModel::Frame frame;
    frame.name = "frame" + std::to_string(robot.frames.size());
    frame.parent = static_cast<int>(robot.frames.size()) - 1;
    frame.transform = Eigen::Translation3d(0.1, -0.05, 0.2) *
                      Eigen::AngleAxisd(0.7 + 0.2 * ratio, Vec3(1, -2, 0.5).normalized());
    frame.axis = axis.normalized();
    frame.joint = joint;
    frame.ratio = ratio;
    frame.offset = offset;
    frame.prismatic = slides;
    robot.frames.push_back(frame);
  };
  add({0, 0, 1}, 0, 1, 0, false);
  add({1, 2, 2}, 1, 1, 0, true);
  add({0, 0, 1}, -1, 1, 0, false);
  add({0, 1, 0}, 2, 1, 0, false);
  add({0, 0, 1}, 1, -0.5, 0.02, true);   // slides with a joint that slides
  add({1, 0, 1}, 1, 6, 0.1, false);      // turns with it: 6 rad/m
  add({0, 1, 1}, 0, 0.05, -0.01, true);  // slides with one that turns: 50 mm/rad
  robot.tips = {{"tip", 6, Pose(Eigen::Translation3d(0.02, 0.03, 0.05)), 1}};
  robot.capsules = {{"finger", 6, {0, 0, 0.01}, {0, 0.02, 0.06}, 0.01, true}};
  robot.palm_frame = 3;
  return robot;
}

}  // namespace morphe::robot
