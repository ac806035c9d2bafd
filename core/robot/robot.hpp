#pragma once

#include <vector>

#include "core/motion/robot_model.hpp"
#include "core/robot/pads.hpp"

namespace morphe::robot {

/// A robot: its model, and data derived once from its frames, tips, centres and capsules. It is
/// const and shared by all threads; each thread has its own scratch buffers. Limits may be changed
/// afterwards, because no derived data depends on them, except on those of prismatic joints, which
/// may only be narrowed.
struct Robot : RobotModel {
  Robot() = default;
  /// Derives the data of a robot from its model.
  explicit Robot(RobotModel table);

  /// [frames] nearest frame, the frame itself included, that a joint moves; -1 if there is no such
  /// frame.
  std::vector<int> moving_frame;
  std::vector<int> arm_joints;   ///< joints that move the palm, in order
  std::vector<int> arm_centres;  ///< frames of the arm's joint centres, in order
  /// [centres] tip of the finger to which the centre belongs; -1 if there is no such tip, or the
  /// centre is the arm's.
  std::vector<int> tip_of_centre;
  std::vector<Pad> pads;                   ///< [tips]
  std::vector<double> chain_centre_count;  ///< [centres] number of centres of its chain
  /// [capsules, n] bounds on the distance that any point of a capsule can travel per radian (or
  /// metre, if prismatic) of each joint [m]; see motion_bounds.hpp.
  JointRows capsule_motion_bounds;
};

/// Returns the positions of the arm's joint centres (metric A), given the poses of the frames [m].
std::vector<Vec3> arm_centre_positions(const Robot& robot,
                                       const std::vector<Pose>& base_from_frame);

}  // namespace morphe::robot
