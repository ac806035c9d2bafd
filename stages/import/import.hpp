#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/motion/demonstration.hpp"
#include "stages/import/conventions.hpp"
#include "stages/import/left_out.hpp"
#include "stages/import/manifest.hpp"

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

/// Reads every recording and hands it to the sink, in the order of the request. One is held at a
/// time. Throws InputError "FILE:LINE: KEY: message" (KEY is a column for CSV) for anything that is
/// not exactly what its format says, and for names that repeat. With a folder among the paths a
/// recording that cannot be read is left out with its reason; InputError if nothing can be read.
Imported import_recordings(const ImportRequest& request,
                           const std::function<void(Demonstration&&)>& sink);

/// The same into a demonstrations.h5 (pipeline/store/demonstration_file.hpp); `seen` is shown each.
Imported write_demonstrations(const ImportRequest& request, const std::filesystem::path& out,
                              const std::function<void(const Demonstration&)>& seen = {});

std::vector<std::string> import_format_names();

}  // namespace morphe::imports
