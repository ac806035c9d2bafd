#pragma once

#include <vector>

#include "core/robot/robot.hpp"

namespace morphe::humanlike {

/// Where the robot is: what every term of a frame's objective reads.
struct RobotState {
  const robot::Robot& robot;
  const JointVector& q;  ///< [n]
  const std::vector<Pose>& base_from_frame;

  const Pose& pose_of(int frame) const { return base_from_frame[static_cast<std::size_t>(frame)]; }
};

}  // namespace morphe::humanlike
