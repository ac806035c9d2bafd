#pragma once

#include "core/motion/robot_model.hpp"

namespace morphe::robot {

/// Computes bounds on the distance that any point of a capsule can travel per radian of each joint:
/// |dx| <= sum_j levers(c, j) |dq_j| for all positions within the joint limits. For a frame that a
/// joint rotates, the bound is the distance from the joint's axis to the capsule's far end along
/// the links between them, with prismatic joints at their largest extension, times the coupling's
/// ratio, summed over the frames of the joint; for prismatic frames it is the ratio alone. levers
/// [capsules, joints] [m/rad or m/m] is stored as Robot::capsule_motion_bounds.
JointRows capsule_motion_bounds(const RobotModel& robot);

/// Computes the same bounds for a sphere that moves with a frame; its centre is given in the frame.
/// [joints]
JointVector sphere_motion_bounds(const RobotModel& robot, int frame, const Vec3& centre,
                                 double radius);

}  // namespace morphe::robot
