#pragma once

#include <string>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::exports {

/// The joints that one controller drives, in the robot's order.
struct JointGroup {
  std::string name;
  std::vector<int> joints;         ///< indices of the robot's joints, increasing
  std::vector<std::string> names;  ///< of the joints
  std::vector<std::string> units;  ///< rad, or m for a prismatic joint
};

/// The accepted values of `--group`, for help texts.
inline constexpr const char* kGroupHelp = "all, arm, hand, or NAME=FIRST..LAST (names of joints)";

/// Returns the joint group for a selection:
///   all               all joints
///   arm               the joints that move the flange; the palm, if no frame's name ends with that
///   hand              all joints but those of the arm
///   NAME=FIRST..LAST  the joints from FIRST to LAST in the robot's order
/// Throws InputError for any other selection and for a group without joints.
JointGroup joint_group(const RobotModel& robot, const std::string& selection);

/// Returns the trajectory restricted to the joints of the group.
Trajectory select_joints(const Trajectory& trajectory, const JointGroup& group);

}  // namespace morphe::exports
