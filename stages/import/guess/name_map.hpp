#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace morphe::imports {

/// A map from recorded names to Morphe's.
using NameMap = std::map<std::string, std::string>;

/// Reads a YAML file with such a map; empty for "". Throws InputError if it is not a map of names.
NameMap read_names(const std::filesystem::path& file);

/// A name map in configs/names.
struct ShippedNameMap {
  std::filesystem::path file;  ///< configs/names/….yaml
  NameMap names;               ///< its contents
};

/// Returns the files of configs/names, as they are found on this system.
std::vector<std::filesystem::path> shipped_name_files();

/// Returns the largest of the maps in configs/names whose keys are all among the recorded names; no
/// value if there is no such map or the two largest are equal in size.
std::optional<ShippedNameMap> find_shipped_names(const std::vector<std::string>& recorded);

}  // namespace morphe::imports
