#pragma once

#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::verify {

/// The ball with which a tip touches: the end nearest to the tip among the capsules that are fixed
/// to it.
struct PadSphere {
  int capsule = -1;                   ///< -1 if the tip has no pad
  Vec3 centre = unknown_point();      ///< in the tip's frame
  Vec3 pad_normal = unknown_point();  ///< unit, the tip's x, in the tip's frame
  double radius = kUnknown;
};

/// Returns the pad of each tip. [tips]
std::vector<PadSphere> pad_spheres(const RobotModel& robot);

/// Returns the point, in the tip's frame, to which the goal of a tip applies at a demonstration
/// time: the tip, or the point on the way from the tip to its pad given by the goals' pad share.
Vec3 tracked_point(const RobotModel& robot, const std::vector<PadSphere>& pads, const Goals& goals,
                   std::size_t tip, double time_s);

}  // namespace morphe::verify
