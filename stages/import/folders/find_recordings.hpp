#pragma once

#include <string>
#include <vector>

#include "stages/import/folders/import_request.hpp"

namespace morphe::imports {

/// The recordings of a request, as a manifest would list them.
struct FoundRecordings {
  std::vector<ManifestEntry> entries;  ///< with distinct names
  std::vector<SkippedFile> left_out;   ///< files that are not imported, with reasons
  bool from_folder = false;            ///< true if there is a folder among the paths
};

/// Finds the recordings of a request. Manifests list their recordings. A recording given directly
/// is taken unchanged except for the hand and for static trials that are given with it
/// (static_pairing.hpp).
///
/// In a folder, including its subfolders, every file that a format recognises is a recording. A
/// static trial is identified by its name or its folder's and by its stationary points; it is
/// paired with the recordings of the same person. A recording is named after its folders and its
/// file; its subject is the person named by the static trial or the first folder; its hand is the
/// one that moves farther; the assumptions made are in its notes. A recordings.yaml in a folder
/// determines the recordings of all files below it: those that it does not list are skipped. Also
/// skipped are files with the same bytes as a previous file or with the same recording in another
/// format, joint angles alone (mot), and HDF5 files.
FoundRecordings find_recordings(const ImportRequest& request);

/// Throws InputError with the obstacles if no recording was imported from the folders of a request.
void require_recordings(const ImportRequest& request, const ImportResult& imported);

}  // namespace morphe::imports
