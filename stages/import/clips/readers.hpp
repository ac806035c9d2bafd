#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "core/motion/demonstration.hpp"
#include "stages/import/recording/format.hpp"

namespace morphe::imports {

// Clips of reconstructed hands, as RecordingFormat describes the two functions.

bool recognises_clip_npz(std::string_view head);
Demonstration read_clip_npz(const RecordingFiles& files);
/// Whether any array of a .npz is called as one that only a clip has. InputError if it has no
/// directory of arrays.
bool holds_a_clip(const std::filesystem::path& file);
/// The hand that reaches, if the clip says it.
std::optional<Side> clip_hand(const std::filesystem::path& file);

}  // namespace morphe::imports
