#pragma once

#include <vector>

#include "core/robot/robot.hpp"

namespace morphe::humanlike {

/// The robot's state, for which the terms of a frame's objective are evaluated.
struct RobotState {
  const robot::Robot& robot;
  const JointVector& q;  ///< [n]
  const std::vector<Pose>& base_from_frame;

  /// Returns the pose of a frame in the base frame.
  const Pose& pose_of(int frame) const { return base_from_frame[frame]; }
};

}  // namespace morphe::humanlike
