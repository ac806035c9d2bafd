#pragma once

#include "core/motion/hand_bones.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::robot {

/// Derives the digits of a hand, in the palm frame, from the joint axes of each tip that follows a
/// human finger. Every joint is at zero, or as close to zero as its limits allow. The axes that are
/// about parallel to the last one before the tip are flexion axes; abduction axes may lie between
/// them. The tip is projected onto the last flexion axis, from there onto the one before, etc.:
///   length = sum of the distances of these projections,
///   knuckle = projection onto the flexion axis nearest to the palm.
/// A digit without a tip or without flexion axes is NaN.
HandBones hand_dimensions(const RobotModel& robot);

}  // namespace morphe::robot
