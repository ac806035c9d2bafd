#pragma once

#include "pipeline/setup/hand_frames.hpp"

namespace morphe::setup {

/// Sets hand.side and the evidence for it:
///   - the geometry of thumb, fingers and palm, which a gripper does not have
///   - "left" or "right" in the names of the hand's root and of the links that carry it, or in the
///     robot's name
///   - the side of the body on which the hand stands, if another link stands at its mirror image
/// Geometry decides if it contradicts the names, and the evidence names both. A
/// gripper without such names or twin has no side. The palm of a left gripper is turned about z, so
/// that y points away from the thumb.
void find_side(const Kinematics& robot, Palm& palm, Hand& hand);

}  // namespace morphe::setup
