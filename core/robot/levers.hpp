#pragma once

#include "core/motion/robot_table.hpp"

namespace morphe::robot {

/// How far any point of a capsule can travel per radian of each joint: |dx| <= sum_j levers(c, j)
/// |dq_j|, whatever the robot's position within its limits. From the joint's axis to the capsule's
/// far end along the links between, stretched as far as those that slide go, times the coupling's
/// ratio, summed over the frames that a joint turns; of those that it slides the ratio alone.
/// levers [capsules, joints] [m/rad or m/m]. Robot::capsule_levers holds it.
JointRows levers_of_capsules(const RobotTable& robot);

/// The same of a ball that moves with a frame, its centre given there. [joints]
JointVector levers_of_ball(const RobotTable& robot, int frame, const Vec3& centre, double radius);

}  // namespace morphe::robot
