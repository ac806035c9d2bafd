#pragma once

#include "core/humanlike/chain_gradients.hpp"
#include "core/humanlike/loads.hpp"
#include "core/robot/robot.hpp"

namespace morphe::humanlike {

/// The robot's arm for metrics B and C, from the shoulder outwards: shoulder, joint centres and the
/// wrist's tip, if there is one; and the frames with which these joints move.
struct ArmChain {
  Chain joints;
  std::vector<int> frames;
};
/// Returns the arm's chain, given the poses of the frames.
ArmChain arm_chain(const robot::Robot& robot, const std::vector<Pose>& base_from_frame);

/// Adds `weight` times a metric of that chain and its gradient to the loads.
void add_chain(const ChainGradient& slopes, const ArmChain& arm, double weight, Loads& loads);

}  // namespace morphe::humanlike
