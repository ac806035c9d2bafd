#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "stages/import/folders/left_out.hpp"
#include "stages/import/folders/manifest.hpp"
#include "stages/import/recording/conventions.hpp"

namespace morphe::imports {

/// What to read. A path is a recording, a manifest (.yaml, see manifest.hpp) that lists several, or
/// a folder (find_recordings.hpp). What stands here of a recording is of those given directly and
/// of those found in folders; of a manifest's as manifest_entries.hpp says.
struct ImportRequest {
  std::vector<std::filesystem::path> paths;
  std::filesystem::path static_trial;  ///< of all of them; empty = found, or none
  std::string format;                  ///< one of import_format_names(); "" = by content
  std::filesystem::path names;         ///< YAML map "recorded name: name used here"; empty = none
  Conventions conventions;
  std::optional<Hands> hand = {};      ///< none: the one that reaches, told from the motion
  std::filesystem::path results = {};  ///< a folder that is no part of the dataset; empty = none
};

/// What came of it.
struct Imported {
  std::vector<ManifestEntry> entries;  ///< of what was read, in order, as a manifest would have it
  std::vector<LeftOut> left_out;       ///< of folders
};

}  // namespace morphe::imports
