#pragma once

#include "core/motion/robot_model.hpp"

namespace morphe {

/// Two links of 0.5 m that turn about z, without capsules or tips: the second link is frame 1.
inline RobotModel two_link_arm() {
  RobotModel robot;
  robot.joint_names = {"shoulder", "elbow"};
  robot.lower = JointVector::Constant(2, -3);
  robot.upper = JointVector::Constant(2, 3);
  RobotModel::Frame frame;
  frame.joint = 0;
  robot.frames.push_back(frame);
  frame.parent = 0;
  frame.joint = 1;
  frame.transform.translation() = Vec3(0.5, 0, 0);
  robot.frames.push_back(frame);
  return robot;
}

}  // namespace morphe
