#pragma once

#include "stages/reconstruct/marker_body.hpp"

namespace morphe::reconstruct {

/// Sets the tips of thumb and index from the markers RTHUM and RFTP on their nails, moved onto the
/// fingers' axes, each towards the other by at most half of their distance. While one of the two is
/// hidden, the hand's orientation is needed. If one is never seen, the other stays at its marker.
void set_marker_tips(const MarkerTrial& trial, HumanMotion& motion);

}  // namespace morphe::reconstruct
