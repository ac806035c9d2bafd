#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "stages/import/folders/import_request.hpp"

namespace morphe::imports {

/// Returns the hand that reaches, if a clip states it. Throws InputError for a damaged clip.
std::optional<Side> hand_in_file(const std::filesystem::path& file, const std::string& format);

/// Returns the recordings of a manifest. The format, names and forward direction of the request
/// replace those of the manifest. If the manifest was given directly, not found in a folder
/// (`in_folder`), axes, unit, rate, joint order and hand of the request do so too; entries of the
/// other hand are left out. If neither gives a hand, the recording's file may (hand_in_file()).
std::vector<ManifestEntry> entries_of(const ImportRequest& request,
                                      const std::filesystem::path& manifest, bool in_folder);

}  // namespace morphe::imports
