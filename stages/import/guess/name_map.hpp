#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace morphe::imports {

/// Recorded name -> name used here.
using NameMap = std::map<std::string, std::string>;

/// A YAML file of such a map; empty for "". InputError if it is no map of names.
NameMap read_names(const std::filesystem::path& file);

struct ShippedNames {
  std::filesystem::path file;  ///< configs/names/….yaml
  NameMap names;
};

/// The map of configs/names of which every name was recorded; of several the largest. Nothing if
/// none is, or two of one size are.
std::optional<ShippedNames> shipped_names_for(const std::vector<std::string>& recorded);

}  // namespace morphe::imports
