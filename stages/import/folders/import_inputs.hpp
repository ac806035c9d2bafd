#pragma once

#include <filesystem>
#include <vector>

#include "stages/import/folders/import_request.hpp"

namespace morphe::imports {

/// Returns the files on which the import of a request may depend, sorted: recordings, manifests and
/// all that these name, the maps of names, and files beside recordings, of which readers use some.
/// A file that appears or disappears changes the list. Throws InputError for unreadable manifests.
std::vector<std::filesystem::path> import_inputs(const ImportRequest& request);

}  // namespace morphe::imports
