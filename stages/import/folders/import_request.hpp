#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "stages/import/folders/manifest.hpp"
#include "stages/import/folders/skipped_file.hpp"
#include "stages/import/recording/conventions.hpp"

namespace morphe::imports {

/// A request to import recordings. The fields other than `paths` apply to recordings given directly
/// and found in folders; for those of a manifest (manifest.hpp), see entries_of().
struct ImportRequest {
  std::vector<std::filesystem::path> paths;  ///< recordings, manifests (.yaml, .yml) and folders
  std::filesystem::path static_trial;  ///< of all recordings; if empty, searched for in the paths
  std::string format;  ///< one of import_format_names(); "" to detect it from the content
  std::filesystem::path name_map;  ///< YAML map "recorded name: Morphe's name"; may be empty
  Conventions conventions;
  std::optional<HandSelection> hand = {};     ///< without a value, the one that reaches
  std::filesystem::path results_folder = {};  ///< skipped inside other folders; may be empty
  bool forward_given = false;  ///< conventions.forward is the user's, also if it is the default
  /// Skip recordings that cannot be read also if manifests list them or if they are given directly,
  /// as those of folders are, as long as another one can be read.
  bool keep_going = false;
};

/// The result of an import.
struct ImportResult {
  std::vector<ManifestEntry> entries;  ///< of the recordings that were read, as in a manifest
  std::vector<SkippedFile> skipped;    ///< files that were not imported
};

}  // namespace morphe::imports
