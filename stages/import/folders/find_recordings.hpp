#pragma once

#include <string>
#include <vector>

#include "stages/import/folders/import_request.hpp"

namespace morphe::imports {

/// The recordings of a request, as a manifest would list them.
struct FoundRecordings {
  std::vector<ManifestEntry> entries;
  std::vector<LeftOut> left_out;
  bool of_folder = false;  ///< there is a folder among the paths
};

/// Manifests list their recordings. A recording given directly is taken as it is, but for the hand,
/// and for static trials that are given with it (static_pairing.hpp).
///
/// In a folder every file that a format recognises is a recording, below it too. A static trial is
/// told by its name or its folder's, and by its points, which stand still; it is paired with the
/// recordings of its person. A recording is called after its folders and its file, its subject is
/// who the name of the static trial or the first folder names, its hand the one that moves farther;
/// what was assumed of it is in its notes. A recordings.yaml in a folder decides for all below it:
/// what it does not list is left out. Left out are, too: what has the bytes of a file before it, or
/// is the same recording in another format beside it; joint angles alone (mot); HDF5 files.
FoundRecordings find_recordings(const ImportRequest& request);

/// InputError if nothing was imported from the folders of a request: with what stands in the way.
void expect_some(const ImportRequest& request, const Imported& imported);

}  // namespace morphe::imports
