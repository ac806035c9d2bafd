#pragma once

#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// Rotates all positions and orientations in the world (streams, calibration, objects) about the
/// vertical through its origin. Joint angles, keypoints, which are in the frame of the hand, and
/// meshes, which are in the frames of their objects, are unchanged.
void rotate_about_vertical(Demonstration& demonstration, double angle_rad);

}  // namespace morphe::imports
