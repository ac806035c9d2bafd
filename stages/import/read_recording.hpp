#pragma once

#include <filesystem>

#include "pipeline/motion/demonstration.hpp"
#include "stages/import/format.hpp"
#include "stages/import/manifest.hpp"

namespace morphe::imports {

/// The demonstration that an entry describes. InputError as import_recordings() says.
Demonstration read_recording(const ManifestEntry& entry);

/// The format that a file's first bytes are of, null if of none. InputError: it cannot be read.
const RecordingFormat* recognised_format(const std::filesystem::path& file);

}  // namespace morphe::imports
