#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "stages/import/folders/import_request.hpp"

namespace morphe::imports {

/// The hand that reaches, if a file of that format says it: clips do. InputError if it is damaged.
std::optional<Side> hand_in_file(const std::filesystem::path& file, const std::string& format);

/// The recordings of a manifest for a request, whose format, names and `forward: recorded` win over
/// what the manifest says. So do its other conventions and the hand where the manifest is given by
/// itself; in a folder it decides. Where neither says a hand, the recording's file does.
std::vector<ManifestEntry> entries_of(const ImportRequest& request,
                                      const std::filesystem::path& manifest, bool in_folder);

}  // namespace morphe::imports
