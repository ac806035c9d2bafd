#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "stages/import/folders/import_request.hpp"

namespace morphe::imports {

/// Returns the hand that reaches, if a file of that format contains it: only clips do. Throws
/// InputError if the file is damaged.
std::optional<Side> hand_in_file(const std::filesystem::path& file, const std::string& format);

/// Returns the recordings of a manifest for a request, whose format, names and `forward: recorded`
/// take precedence over the manifest's. The same holds for its other conventions and the hand if
/// the manifest is given directly; in a folder the manifest takes precedence. If neither gives a
/// hand, it is taken from the recording's file.
std::vector<ManifestEntry> entries_of(const ImportRequest& request,
                                      const std::filesystem::path& manifest, bool in_folder);

}  // namespace morphe::imports
