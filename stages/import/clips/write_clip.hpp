#pragma once

#include <filesystem>

#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// Whether a clip holds all that a motion is rebuilt from: joints of a skeleton, or the keypoints
/// of a hand alone.
bool is_as_a_clip(const Demonstration& demonstration);

/// Writes such a demonstration as a clip (docs/clips.md) that is read as the same joints, objects
/// and facts: in the world's axes and metres, a hand's joints in the order `openpose`. Joints with
/// rotations and those that are no hand's are body_…. InputError if it cannot be written.
void write_clip(const Demonstration& demonstration, const std::filesystem::path& file);

}  // namespace morphe::imports
