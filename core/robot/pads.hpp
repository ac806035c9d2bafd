#pragma once

#include <vector>

#include "core/motion/robot_table.hpp"

namespace morphe::robot {

struct Robot;

/// What of a finger touches the object: the ball that ends the tip's own capsule, on the tip's
/// side. Any direction of its outer half is part of the pad; the middle of it is where the tip's x
/// axis points.
struct Pad {
  int capsule = -1;              ///< -1: no capsule is fixed to the tip, it has no pad
  Vec3 centre = unseen_point();  ///< in the tip's frame (RobotTable::Tip::frame) [m]
  double radius = kNotSeen;      ///< [m]
  Vec3 middle = unseen_point();  ///< unit, in the tip's frame
};

/// [tips] Of several capsules that move with a tip, the one that ends nearest to it.
std::vector<Pad> find_pads(const RobotTable& robot);

/// Whether a capsule is that of a pad.
bool is_pad(const Robot& robot, int capsule);

/// The point of a tip's link at a share of the way from the tip to the centre of its pad, which a
/// goal asks for (Goals::pad_share), in the base frame [m].
Vec3 goal_point(const Robot& robot, const std::vector<Pose>& base_from_frame, std::size_t tip,
                double pad_share);

}  // namespace morphe::robot
