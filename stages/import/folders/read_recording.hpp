#pragma once

#include <filesystem>

#include "core/motion/demonstration.hpp"
#include "stages/import/folders/manifest.hpp"
#include "stages/import/recording/format.hpp"

namespace morphe::imports {

/// The demonstration that an entry describes. InputError as import_recordings() says.
Demonstration read_recording(const ManifestEntry& entry);

/// The format that a file's first bytes are of, null if of none. InputError: it cannot be read.
const RecordingFormat* recognised_format(const std::filesystem::path& file);

}  // namespace morphe::imports
