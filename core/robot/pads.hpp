#pragma once

#include <vector>

#include "core/motion/robot_model.hpp"

namespace morphe::robot {

struct Robot;

/// The pad of a finger, with which it touches the object: the spherical cap of the capsule that is
/// fixed to the tip, at the capsule's end near the tip. Any direction of the outer hemisphere
/// belongs to the pad; its middle is the direction of the tip's x axis.
struct Pad {
  /// -1 if no capsule is fixed to the tip, so that it has no pad.
  int capsule = -1;
  Vec3 centre = unknown_point();     ///< in the tip's frame (RobotModel::Tip::frame) [m]
  double radius = kUnknown;          ///< [m]
  Vec3 direction = unknown_point();  ///< unit vector in the tip's frame
};

/// Returns the pad of every tip [tips]. If several capsules move with a tip, the one with the end
/// nearest to it has the pad.
std::vector<Pad> find_pads(const RobotModel& robot);

/// Returns true if the capsule has a pad.
bool is_pad(const Robot& robot, int capsule);

/// Returns the tracked point of a tip in the base frame [m]: the point at `tip_to_pad_share` of the
/// way from the tip to the centre of its pad, to which a goal applies (Goals::tip_to_pad_share).
Vec3 tracked_point(const Robot& robot, const std::vector<Pose>& base_from_frame, std::size_t tip,
                   double tip_to_pad_share);

}  // namespace morphe::robot
