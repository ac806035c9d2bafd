#pragma once

#include "core/motion/finding.hpp"
#include "core/robot/tree.hpp"

namespace morphe::robot {

/// Returns the unit of a joint's position: metre for a sliding joint, radian for a revolute one.
inline FindingUnit joint_unit(const RobotModel& robot, int joint) {
  return is_prismatic(robot, joint) ? FindingUnit::metre : FindingUnit::radian;
}

}  // namespace morphe::robot
