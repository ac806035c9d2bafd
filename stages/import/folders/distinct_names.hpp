#pragma once

#include <string>
#include <vector>

#include "stages/import/folders/manifest.hpp"

namespace morphe::imports {

/// An entry and candidates for its name.
struct NamedEntry {
  ManifestEntry entry;
  std::vector<std::string> names;  ///< the best first; without any, the entry keeps its own name
  int request_index = 0;           ///< index in ImportRequest::paths of the path it came from
};

/// Returns "P01_reach" for the folder P01 and the file reach. A folder with whose name the rest
/// already begins ("P01_reach" in P01) is left out, unless `keep_all` is set.
std::string joined_name(const std::vector<std::string>& folders, const std::string& stem,
                        bool keep_all = false);

/// Gives each entry its first unused candidate or, if all are used, the first one with a number.
/// Throws InputError for an invalid name of an HDF5 group, and for a used name without candidates.
std::vector<ManifestEntry> assign_unique_names(std::vector<NamedEntry> entries);

}  // namespace morphe::imports
