#pragma once

#include <filesystem>

#include "core/motion/demonstration.hpp"
#include "stages/import/folders/manifest.hpp"
#include "stages/import/recording/format.hpp"

namespace morphe::imports {

/// Reads the demonstration that an entry describes. Throws InputError as import_recordings() does.
Demonstration read_recording(const ManifestEntry& entry);

/// Returns the format recognised from a file's first bytes, null if there is no such format. Throws
/// InputError if the file cannot be read.
const RecordingFormat* recognised_format(const std::filesystem::path& file);

}  // namespace morphe::imports
