#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "stages/import/folders/manifest.hpp"
#include "stages/import/folders/skipped_file.hpp"
#include "stages/import/recording/conventions.hpp"

namespace morphe::imports {

/// A request to import recordings. A path is a recording, a manifest (.yaml, see manifest.hpp) that
/// lists several, or a folder (find_recordings.hpp). The other fields apply to recordings given
/// directly and to those found in folders; for those of a manifest, see manifest_entries.hpp.
struct ImportRequest {
  std::vector<std::filesystem::path> paths;  ///< recordings, manifests and folders
  /// Static trial of all recordings; if empty, it is searched for in the request.
  std::filesystem::path static_trial;
  std::string format;  ///< one of import_format_names(); "" to detect it from the content
  std::filesystem::path name_map;  ///< YAML map "recorded name: name used here"; may be empty
  Conventions conventions;
  /// Hands to import; without a value, the one that reaches, determined from the motion.
  std::optional<HandSelection> hand = {};
  /// A folder that is not part of the dataset; may be empty.
  std::filesystem::path results_folder = {};
};

/// The result of an import.
struct ImportResult {
  /// Entries of the recordings that were read, in order, as in a manifest.
  std::vector<ManifestEntry> entries;
  std::vector<SkippedFile> skipped;  ///< skipped files of folders
};

}  // namespace morphe::imports
