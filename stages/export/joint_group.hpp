#pragma once

#include <string>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::exports {

/// Joints that one controller drives, in the robot's order.
struct JointGroup {
  std::string name;
  std::vector<int> joints;         ///< of the robot's, increasing
  std::vector<std::string> names;  ///< theirs
  std::vector<std::string> units;  ///< rad, or m of a joint that slides
};

/// What `--group` may say, for a person.
inline constexpr const char* kGroupHelp = "all, arm, hand, or NAME=FIRST..LAST by joints";

/// all; arm: the joints that move its flange, or the palm where no frame is called flange; hand:
/// the others; NAME=FIRST..LAST: those from one joint to another in the robot's order. InputError
/// for anything else, and for a group without joints.
JointGroup joint_group(const RobotTable& robot, const std::string& asked);

/// The same motion of these joints alone.
Trajectory of_group(const Trajectory& trajectory, const JointGroup& group);

}  // namespace morphe::exports
