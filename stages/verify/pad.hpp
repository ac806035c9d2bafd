#pragma once

#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::verify {

/// The sphere with which a tip touches: of the ends of all capsules fixed to the tip, the nearest.
struct PadSphere {
  int capsule = -1;                   ///< -1 if the tip has no pad
  Vec3 centre = unknown_point();      ///< in the frame of the tip's link
  Vec3 pad_normal = unknown_point();  ///< unit, the tip's x, in the frame of the tip's link
  double radius = kUnknown;
};

/// Returns the pad of each tip [tips].
std::vector<PadSphere> pad_spheres(const RobotModel& robot);

/// Returns the point, in the frame of the tip's link, to which the goal of a tip applies at a
/// demonstration time: at the goals' tip_to_pad_share (0 without) of the line from tip to pad.
Vec3 tracked_point(const RobotModel& robot, const std::vector<PadSphere>& pads, const Goals& goals,
                   int tip, double time_s);

}  // namespace morphe::verify
