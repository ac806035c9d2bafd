#pragma once

#include <vector>

#include "core/motion/robot_model.hpp"

namespace morphe::robot {

/// The pad of a finger, with which it touches the object: the hemisphere at the end, near the tip,
/// of the capsule that is fixed to the tip. Its middle is in the direction of the tip's x axis.
struct Pad {
  int capsule = -1;                  ///< -1 if no capsule is fixed to the tip: it has no pad
  Vec3 centre = unknown_point();     ///< in the tip's frame (RobotModel::Tip::frame) [m]
  double radius = kUnknown;          ///< [m]
  Vec3 direction = unknown_point();  ///< unit vector in the tip's frame
};

/// Returns the pads [tips]. Among the capsules that move with a tip, the end nearest to the tip has
/// the pad.
std::vector<Pad> find_pads(const RobotModel& robot);

}  // namespace morphe::robot
