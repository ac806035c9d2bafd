#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "stages/import/folders/manifest.hpp"

namespace morphe::imports {

/// An entry that takes the first of these names that is unused; without names, it keeps its own.
struct NamedEntry {
  ManifestEntry entry;
  std::vector<std::string> names;  ///< candidate names, the best first
  std::size_t request_index = 0;   ///< index of the path of the request that it came from
};

/// Returns for example "P01_reach" for the folder P01 and the file reach. A folder whose name is
/// already a prefix of the rest is left out, unless `all` is set.
std::string joined_name(const std::vector<std::string>& folders, const std::string& stem,
                        bool all = false);

/// Returns the entries with distinct names. Throws InputError for a name that is invalid for a
/// group, and for two entries with the same name and no alternative.
std::vector<ManifestEntry> assign_unique_names(std::vector<NamedEntry> entries);

}  // namespace morphe::imports
