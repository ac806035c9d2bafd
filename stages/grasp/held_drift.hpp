#pragma once

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"

namespace morphe::grasp {

/// The motion of the pads in the palm's frame while the hand carries the target: that of the
/// contacts on the target, which is attached to the palm.
struct HeldDrift {
  double displacement_m = kUnknown, turn_rad = kUnknown;
};

/// Returns the largest displacement of the centre of a touching pad, and the largest rotation of
/// its link, since the grasp, over the samples from plan.grasp.sample to the target's release.
/// Unknown if the movement carries nothing or no pad touches the target.
HeldDrift held_drift(const robot::Robot& robot, const Plan& plan);

}  // namespace morphe::grasp
