#pragma once

#include <filesystem>

#include "core/motion/demonstration.hpp"
#include "stages/import/folders/manifest.hpp"
#include "stages/import/recording/format.hpp"

namespace morphe::imports {

/// Reads the demonstration that an entry describes; its hand must not be `both`. Throws InputError
/// as import_recordings() does, and UnresolvedImport as read_or_propose() does or, if it is to be
/// `questioned`, for a doubt of the audit that the user must answer.
Demonstration read_recording(const ManifestEntry& entry, bool questioned = true);

/// Returns the format that recognises a file, or null. Throws InputError for unreadable files.
const RecordingFormat* recognised_format(const std::filesystem::path& file);

}  // namespace morphe::imports
