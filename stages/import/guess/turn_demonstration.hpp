#pragma once

#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// Turns everything of a demonstration that has a place or an orientation in the world about the
/// vertical through its origin by an angle [rad]: streams, calibration, objects. Keypoints beside
/// an arm, which are a hand's shape, and meshes, which lie in their object's frame, stay.
void turn_about_vertical(Demonstration& demonstration, double angle);

}  // namespace morphe::imports
