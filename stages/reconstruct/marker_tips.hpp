#pragma once

#include "stages/reconstruct/marker_body.hpp"

namespace morphe::reconstruct {

/// Tips of thumb and index from the markers RTHUM and RFTP on their nails, moved onto the fingers'
/// axes, each towards the other, at most to the middle between them. Needs the hand's orientation
/// where one of the two is hidden. One that is never seen leaves the other where its marker is.
void set_marker_tips(const MarkerTrial& trial, HumanMotion& motion);

}  // namespace morphe::reconstruct
