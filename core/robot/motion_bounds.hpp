#pragma once

#include "core/motion/robot_model.hpp"

namespace morphe::robot {

/// Returns the levers [capsules, joints] [m/rad or m/m] that bound the motion of any point x of a
/// capsule c at all positions within the joint limits: |dx| <= sum_j levers(c, j) |dq_j|. The lever
/// of a joint is summed over the frames that it moves. A rotated frame adds |ratio| times the
/// distance from its axis to the capsule's far end along the links between them, with prismatic
/// joints at their largest extension; a prismatic frame adds |ratio|.
JointRows capsule_motion_bounds(const RobotModel& robot);

/// Returns the same levers [joints] for a sphere that moves with a frame, its centre in that frame.
JointVector sphere_motion_bounds(const RobotModel& robot, int frame, const Vec3& centre,
                                 double radius);

}  // namespace morphe::robot
