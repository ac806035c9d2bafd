#pragma once

#include "core/humanlike/metrics.hpp"

namespace morphe::humanlike {

/// Returns the goals of a chain in joint-to-joint mode: the robot's links, from its first joint on,
/// each with the direction of the human's link at the same normalised arc length as the robot
/// link's midpoint. This corresponds to copying angles of corresponding joints, but is independent
/// of the lengths and of the number of joints. Both chains need at least two joints and a positive
/// length; NaN in the human's chain gives NaN.
Chain match_link_directions(const Chain& human, const Chain& robot);

}  // namespace morphe::humanlike
