#pragma once

#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// Rotates all positions and orientations of a demonstration in the world about the vertical
/// through its origin by an angle [rad]: streams, calibration, objects. Keypoints beside an arm,
/// which are the shape of a hand, and meshes, which are in their object's frame, are unchanged.
void rotate_about_vertical(Demonstration& demonstration, double angle);

}  // namespace morphe::imports
