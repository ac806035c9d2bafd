#pragma once

#include <filesystem>
#include <functional>

#include "core/motion/demonstration.hpp"
#include "stages/import/folders/import_request.hpp"

namespace morphe::imports {

/// Reads every recording and hands it to the sink, in the order of the request. One is held at a
/// time. Throws InputError "FILE:LINE: KEY: message" (KEY is a column for CSV) for anything that is
/// not exactly what its format says, and for names that repeat. With a folder among the paths a
/// recording that cannot be read is left out with its reason; InputError if nothing can be read.
Imported import_recordings(const ImportRequest& request,
                           const std::function<void(Demonstration&&)>& sink);

/// The same into a demonstrations.h5 (core/store/demonstration_file.hpp); `seen` is shown each.
Imported write_demonstrations(const ImportRequest& request, const std::filesystem::path& out,
                              const std::function<void(const Demonstration&)>& seen = {});

}  // namespace morphe::imports
