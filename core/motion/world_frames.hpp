#pragma once

#include "core/motion/geometry.hpp"

namespace morphe {

inline Pose unseen_pose() {
  Pose pose = Pose::Identity();
  pose.matrix().topRows<3>().setConstant(kNotSeen);
  return pose;
}
inline bool seen(const Pose& pose) { return pose.matrix().allFinite(); }

/// Where things stand as a movement begins, seen from the robot's base: what a user needs to put
/// something of his own beside them. NaN: there is no such thing.
struct WorldFrames {
  Pose base_from_world = unseen_pose();   ///< the recording's frame; of a hand alone the hand's
  Pose base_from_table = unseen_pose();   ///< centre of its top, axes of the table, z up
  Pose base_from_target = unseen_pose();  ///< the target's centre and axes
  Vec3 shoulder = unseen_point();         ///< the person's own, where it was recorded [m]
};

}  // namespace morphe
