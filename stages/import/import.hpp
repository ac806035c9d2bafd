#pragma once

#include <filesystem>
#include <functional>

#include "core/motion/demonstration.hpp"
#include "stages/import/folders/import_request.hpp"

namespace morphe::imports {

/// Reads every recording and passes it to the sink, in the order of the request. Only one is in
/// memory at a time. Throws InputError "FILE:LINE: KEY: message" (KEY is a column for CSV) for any
/// violation of a recording's format, and for repeated names. With a folder among the paths, a
/// recording that cannot be read is skipped with its reason; InputError if no recording can be
/// read.
ImportResult import_recordings(const ImportRequest& request,
                               const std::function<void(Demonstration&&)>& sink);

/// Reads the recordings and writes them to a demonstrations.h5 (core/store/demonstration_file.hpp).
/// `seen` is called with each of them.
ImportResult write_demonstrations(const ImportRequest& request, const std::filesystem::path& out,
                                  const std::function<void(const Demonstration&)>& seen = {});

}  // namespace morphe::imports
