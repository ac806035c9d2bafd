#pragma once

#include <vector>

#include "stages/import/folders/import_request.hpp"

namespace morphe::imports {

/// The recordings of a request, as a manifest would list them.
struct FoundRecordings {
  std::vector<ManifestEntry> entries;  ///< with distinct names
  std::vector<SkippedFile> left_out;   ///< files that are not imported, with reasons
  bool from_folder = false;            ///< true if there is a folder among the paths
};

/// Finds the recordings of a request: those of its manifests, those given directly, and those in
/// its folders and their subfolders, where every file that a format recognises is one, except for
/// - files that a recordings.yaml in a folder above them does not list,
/// - duplicates (remove_duplicates()), and
/// - files with joint angles alone (mot).
/// Files with is_static_trial() are paired with recordings of the same person (static_pairing.hpp).
/// A recording without a given hand has the one that reaches (reaching_hand()). In a folder, a
/// recording is named after its folders and file, and its subject is the person whom the name of
/// the static trial or of a folder states. Assumptions are in the entry's notes.
FoundRecordings find_recordings(const ImportRequest& request);

/// If no recording was imported, throws InputError with the errors of all that could not be read,
/// as UnresolvedImport if the user can answer one, or, for a folder without such errors, with all
/// reasons and their counts.
void require_recordings(const ImportRequest& request, const ImportResult& imported);

}  // namespace morphe::imports
