#pragma once

#include "core/humanlike/knots.hpp"

namespace morphe::humanlike {

/// Returns the goals of the robot's joints in joint-to-joint mode: a chain of the robot's links,
/// from its first joint on. Each link has the direction of the human's link at the normalised arc
/// length of the robot link's midpoint. This is like copying angles, for any lengths and number of
/// joints. Both chains need at least two joints and a positive length; NaN in the human's chain
/// gives NaN.
Chain match_link_directions(const Chain& human, const Chain& robot);

}  // namespace morphe::humanlike
