#pragma once

#include "core/humanlike/metrics.hpp"

namespace morphe::humanlike {

/// Joint-to-joint of a chain: the robot's links, from its first joint on, each pointing as the
/// human's link that lies beside its middle by normalised arc length. What angles at corresponding
/// joints come to whatever the lengths, and where the robot has more joints than the human or
/// fewer. Both chains have two joints at least and length; NaN where the human's has one.
Chain posed_like(const Chain& human, const Chain& robot);

}  // namespace morphe::humanlike
