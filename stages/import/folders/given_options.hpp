#pragma once

#include <string>
#include <vector>

#include "stages/import/folders/dataset_files.hpp"
#include "stages/import/folders/import_request.hpp"

namespace morphe::imports {

/// Returns the options of the command line that a request has, such as "--unit".
std::vector<std::string> given_options(const ImportRequest& request);

/// Throws InputError if an option of the request changes no recording: because manifests in folders
/// list all of them, because their formats do not use it, or because manifests state their static
/// trials. For an option that some entries of `contents` do not use, they get a note.
void expect_effect_of_options(const ImportRequest& request, DatasetContents& contents);

}  // namespace morphe::imports
