#pragma once

#include <filesystem>

#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// Returns true if a clip can hold all data from which the motion is reconstructed: joints of a
/// skeleton, or the keypoints of a hand alone.
bool can_write_clip(const Demonstration& demonstration);

/// Writes such a demonstration as a clip (docs/clips.md) from which the same joints, objects and
/// properties are read: in the world's axes and metres, a hand's joints in the order `openpose`.
/// Joints with orientations and those that do not belong to a hand are written as body_…. Throws
/// InputError if it cannot be written.
void write_clip(const Demonstration& demonstration, const std::filesystem::path& file);

}  // namespace morphe::imports
