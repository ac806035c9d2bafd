#pragma once

#include <filesystem>

#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// Returns true for a skeleton, or a hand's keypoints without markers, and no sensors or glove.
bool can_write_clip(const Demonstration& demonstration);

/// Writes a demonstration with can_write_clip() as a clip (docs/clips.md), from which the same
/// joints, objects and metadata are read. It is in the world's axes and metres; a hand's joints
/// have the order `openpose`. Joints of no hand, and those with orientations or confidences of
/// their own, are written as body_…. Throws InputError if the file cannot be written.
void write_clip(const Demonstration& demonstration, const std::filesystem::path& file);

}  // namespace morphe::imports
