#pragma once

#include <filesystem>
#include <functional>

#include "core/motion/demonstration.hpp"
#include "stages/import/folders/import_request.hpp"

namespace morphe::imports {

/// Reads the recordings one at a time, in the order of the request, and passes each to `sink`.
/// Throws InputError "FILE:LINE: KEY: message" (KEY is a column for CSV) for a violation of a
/// format and for repeated names. If a path of the request is a folder, or with `keep_going`,
/// recordings that cannot be read are skipped with their reasons, and InputError is thrown only if
/// no other was read. Throws InputError for options of the request that have no effect.
ImportResult import_recordings(const ImportRequest& request,
                               const std::function<void(Demonstration&&)>& sink);

/// Writes the recordings to `out`, a demonstrations.h5 (core/store/demonstration_file.hpp), and
/// calls `seen` with each. Throws InputError as above, and if `out` is one of the files read.
ImportResult write_demonstrations(const ImportRequest& request, const std::filesystem::path& out,
                                  const std::function<void(const Demonstration&)>& seen = {});

}  // namespace morphe::imports
