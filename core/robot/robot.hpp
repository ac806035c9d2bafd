#pragma once

#include <vector>

#include "core/motion/robot_model.hpp"
#include "core/robot/pads.hpp"

namespace morphe::robot {

/// A robot: its model, and data derived once from its frames, tips, centres and capsules. It is
/// const and shared by all threads; each thread has its own scratch buffers. Limits of revolute
/// joints may be changed afterwards, because no derived data depends on them; those of prismatic
/// joints may only be narrowed.
struct Robot : RobotModel {
  Robot() = default;
  /// Derives the data of a robot from its model.
  explicit Robot(RobotModel table);

  std::vector<int> moving_frame;   ///< [frames] as moving_frame_of() returns it
  std::vector<int> arm_joints;     ///< joints that move the palm, in order
  std::vector<int> arm_centres;    ///< frames of the arm's joint centres, in order
  std::vector<int> tip_of_centre;  ///< [centres] first fingertip beyond; -1 if none, or for the arm
  std::vector<Pad> pads;           ///< [tips]
  std::vector<double> chain_centre_count;  ///< [centres] number of centres of its chain
  JointRows capsule_motion_bounds;         ///< [capsules, n] levers, see motion_bounds.hpp
};

/// Returns true if one of the capsule's ends is a pad.
bool is_pad(const Robot& robot, int capsule);

/// Returns the point of a tip to which its goal applies, in the base frame [m]: that at the share
/// `tip_to_pad_share`, 0 … 1, of the way from the tip to the centre of its pad.
Vec3 tracked_point(const Robot& robot, const std::vector<Pose>& base_from_frame, std::ptrdiff_t tip,
                   double tip_to_pad_share);

/// Returns the positions of the arm's joint centres in the base frame [m].
std::vector<Vec3> arm_centre_positions(const Robot& robot,
                                       const std::vector<Pose>& base_from_frame);

}  // namespace morphe::robot
