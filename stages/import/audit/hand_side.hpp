#pragma once

#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// Returns how far the tips of thumb and fingers are to the palm's side of the plane through wrist,
/// finger base and the line across the hand, if the hand is the one that its side says [m]; the
/// median over the recording, NaN if it does not show these points. It is negative for a mirrored
/// hand, and near 0 if the fingers are stretched. A static trial that shows styloids or knuckles
/// gives the plane to a recording of a marker cluster on the hand.
double palmward_tips_m(const Demonstration& recording);

}  // namespace morphe::imports
