#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace morphe::imports {

/// A map from recorded names to names used here.
using NameMap = std::map<std::string, std::string>;

/// Reads a YAML file with such a map; empty for "". Throws InputError if it is not a map of names.
NameMap read_names(const std::filesystem::path& file);

/// A name map in configs/names.
struct ShippedNameMap {
  std::filesystem::path file;  ///< configs/names/….yaml
  NameMap names;               ///< its contents
};

/// Returns the map of configs/names all of whose names were recorded; the largest if there are
/// several. Returns no map if no map matches, or if the two largest are equal in size.
std::optional<ShippedNameMap> find_shipped_names(const std::vector<std::string>& recorded);

}  // namespace morphe::imports
