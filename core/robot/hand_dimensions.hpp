#pragma once

#include "core/motion/hand_bones.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::robot {

/// Derives the digits of a hand from its joint axes, in the palm frame, each for the tip that
/// follows that human finger. Going up from the tip, the axes parallel to the last one are flexion
/// axes (abduction axes may lie between them); the one nearest to the palm is the knuckle:
///   length = distance of the tip from the last axis + distances between consecutive flexion axes,
///   knuckle = projection of the tip onto the knuckle's axis,
/// with every joint at zero, or as close to zero as its limits allow.
HandBones hand_dimensions(const RobotModel& robot);

}  // namespace morphe::robot
