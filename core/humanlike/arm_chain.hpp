#pragma once

#include <vector>

#include "core/humanlike/knots.hpp"
#include "core/robot/robot.hpp"

namespace morphe::humanlike {

/// The robot's arm for metrics B and C: shoulder, the arm's joint centres, and the wrist's tip if
/// there is one.
struct ArmChain {
  Chain joints;
  std::vector<int> frames;  ///< with which the joints move, -1 = base
};
/// Returns the arm's chain, given the poses of the frames.
ArmChain arm_chain(const robot::Robot& robot, const std::vector<Pose>& base_from_frame);

/// The wrist of a robot's arm: the last joint of its chain, or the origin of the palm if the chain
/// ends at the elbow.
struct ArmWrist {
  Vec3 position;  ///< [m]
  int frame;      ///< with which it moves
};
/// Returns the wrist of a robot that has an arm, given the poses of the frames.
ArmWrist arm_wrist(const robot::Robot& robot, const std::vector<Pose>& base_from_frame);

}  // namespace morphe::humanlike
