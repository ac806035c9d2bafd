#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "core/motion/demonstration.hpp"
#include "stages/import/recording/format.hpp"

namespace morphe::imports {

// RecordingFormat is the contract of the first two functions.

/// Returns true for the first bytes of a .npz, which may be a clip.
bool recognises_clip_npz(std::string_view head);
/// Reads a clip.
Demonstration read_clip_npz(const RecordingFiles& files);
/// Returns true if a .npz has a key that only clips have. Throws InputError for another file.
bool holds_a_clip(const std::filesystem::path& file);
/// Returns the hand that reaches, if the clip states it.
std::optional<Side> clip_reaching_side(const std::filesystem::path& file);

}  // namespace morphe::imports
