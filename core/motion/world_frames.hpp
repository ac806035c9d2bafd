#pragma once

#include "core/motion/geometry.hpp"

namespace morphe {

/// Returns a pose whose elements are all NaN.
inline Pose unknown_pose() {
  Pose pose = Pose::Identity();
  pose.matrix().topRows<3>().setConstant(kUnknown);
  return pose;
}
/// Returns true if all elements of the pose are finite.
inline bool is_known(const Pose& pose) { return pose.matrix().allFinite(); }

/// The reference frames at the begin of a movement, in the robot's base frame, relative to which
/// users place their own objects. NaN if the frame does not exist.
struct WorldFrames {
  Pose base_from_world = unknown_pose();   ///< the recording; for a hand alone, the hand's frame
  Pose base_from_table = unknown_pose();   ///< centre of the table's top, axes of the table, z up
  Pose base_from_target = unknown_pose();  ///< centre and axes of the target
  Vec3 shoulder = unknown_point();         ///< the person's own shoulder, if it was recorded [m]
};

}  // namespace morphe
