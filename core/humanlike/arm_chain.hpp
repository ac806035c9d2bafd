#pragma once

#include "core/humanlike/chain_slopes.hpp"
#include "core/humanlike/loads.hpp"
#include "core/robot/robot.hpp"

namespace morphe::humanlike {

/// The robot's arm as metrics B and C see it, from the shoulder outwards: shoulder, joint centres
/// and the wrist's tip, if there is one; and the frames that the joints move with.
struct ArmChain {
  Chain joints;
  std::vector<int> frames;
};
ArmChain arm_chain(const robot::Robot& robot, const std::vector<Pose>& base_from_frame);

/// Adds `weight` times a metric of that chain with its slopes.
void add_chain(const ChainSlopes& slopes, const ArmChain& arm, double weight, Loads& loads);

}  // namespace morphe::humanlike
