#pragma once

#include "core/motion/hand_bones.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::robot {

/// The digits of a hand from its joints' axes, in its palm frame, each by the tip that follows that
/// human finger. From the tip upwards the axes that are parallel to the last one bend the finger
/// (what spreads it may lie between them); the first of them is its knuckle:
///   length = distance of the tip from the last axis + distances between such axes in turn,
///   knuckle = foot of the tip on the first,
/// with every joint at zero, or as near to it as its limits let it be.
HandBones hand_bones(const RobotTable& robot);

}  // namespace morphe::robot
