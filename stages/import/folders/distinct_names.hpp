#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "stages/import/folders/manifest.hpp"

namespace morphe::imports {

/// An entry that is to be called by the first of these names that is free, none = its own.
struct NamedEntry {
  ManifestEntry entry;
  std::vector<std::string> names;
  std::size_t path = 0;  ///< of the request, that it came from
};

/// "P01_reach" of folders P01 and file reach; a folder whose name what follows begins with is left
/// out, unless `all` are asked for.
std::string joined_name(const std::vector<std::string>& folders, const std::string& stem,
                        bool all = false);

/// The entries with names that differ. InputError for one that cannot name a group, and for two of
/// the same name that say no other.
std::vector<ManifestEntry> give_names(std::vector<NamedEntry> entries);

}  // namespace morphe::imports
