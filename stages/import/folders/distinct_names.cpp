#include "stages/import/folders/distinct_names.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <set>

#include "core/motion/input_error.hpp"
#include "stages/import/recording/name_words.hpp"

namespace morphe::imports {
namespace {

/// Returns true if the name already starts with the folder's name: P01 of P01_reach, but not P1 of
/// P10.
bool has_folder_prefix(const std::string& folder, const std::string& name) {
  if (!name.starts_with(folder)) return false;
  for (const NameWord& word : split_name(name)) {
    if (word.end == folder.size()) return true;
  }
  return false;
}

}  // namespace

std::string joined_name(const std::vector<std::string>& folders, const std::string& stem,
                        bool all) {
  std::string name = stem;
  for (auto folder = folders.rbegin(); folder != folders.rend(); ++folder) {
    if (all || !has_folder_prefix(*folder, name)) name = *folder + "_" + name;
  }
  return name;
}

std::vector<ManifestEntry> assign_unique_names(std::vector<NamedEntry> entries) {
  std::set<std::string> taken;
  std::vector<ManifestEntry> named;
  for (NamedEntry& one : entries) {
    ManifestEntry& entry = one.entry;
    if (entry.name.empty()) entry.name = std::filesystem::path(entry.file).stem().string();
    if (entry.name.find('/') != std::string::npos || entry.name == "." || entry.name == "..") {
      throw InputError(fmt::format("{}: name: '{}' is not a valid name of an HDF5 group",
                                   entry.file, entry.name));
    }
    if (one.names.empty() && taken.contains(entry.name)) {
      throw InputError(fmt::format("{}: name: '{}' appears twice", entry.file, entry.name));
    }
    for (std::size_t k = 0; !one.names.empty() && (k == 0 || taken.contains(entry.name)); ++k) {
      entry.name = k < one.names.size()
                       ? one.names[k]
                       : fmt::format("{}_{}", one.names[0], k - one.names.size() + 2);
    }
    taken.insert(entry.name);
    named.push_back(std::move(entry));
  }
  return named;
}

}  // namespace morphe::imports
