#pragma once

#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::verify {

/// The ball with which a tip touches: the end nearest to it of the capsules that are fixed to it.
struct PadBall {
  int capsule = -1;              ///< -1: the tip has none
  Vec3 centre = unseen_point();  ///< in the tip's frame
  Vec3 middle = unseen_point();  ///< unit, the tip's x, in the tip's frame
  double radius = kNotSeen;
};

std::vector<PadBall> pad_balls(const RobotTable& robot);  // [tips]

/// What the goal of a tip asks for at a demonstration time, in the tip's frame: the tip, or so much
/// of the way to its pad as the goals say.
Vec3 asked_point(const RobotTable& robot, const std::vector<PadBall>& pads, const Goals& goals,
                 std::size_t tip, double time_s);

}  // namespace morphe::verify
