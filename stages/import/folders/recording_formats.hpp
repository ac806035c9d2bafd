#pragma once

#include <string>
#include <vector>

#include "stages/import/recording/format.hpp"

namespace morphe::imports {

/// Every format there is: one line each, in the order in which they are tried.
const std::vector<RecordingFormat>& recording_formats();

/// The name of every format, in the order in which they are tried.
std::vector<std::string> import_format_names();

}  // namespace morphe::imports
