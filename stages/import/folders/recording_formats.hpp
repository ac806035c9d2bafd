#pragma once

#include <string>
#include <vector>

#include "stages/import/recording/format.hpp"

namespace morphe::imports {

/// Returns all formats, in the order in which they are tried.
const std::vector<RecordingFormat>& recording_formats();

/// Returns the names of all formats, in the order in which they are tried.
std::vector<std::string> import_format_names();

}  // namespace morphe::imports
