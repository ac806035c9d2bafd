#include "stages/import/folders/distinct_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "core/motion/input_error.hpp"
#include "stages/import/recording/name_words.hpp"

namespace morphe::imports {
namespace {

/// Returns true for the folder P01 and the name P01_reach, but not for P1 and P10.
bool has_folder_prefix(const std::string& folder, const std::string& name) {
  return name.starts_with(folder) &&
         std::ranges::count(split_name(name), folder.size(), &NameWord::end) > 0;
}

}  // namespace

std::string joined_name(const std::vector<std::string>& folders, const std::string& stem,
                        bool keep_all) {
  std::string name = stem;
  for (auto folder = folders.rbegin(); folder != folders.rend(); ++folder) {
    if (keep_all || !has_folder_prefix(*folder, name)) name = *folder + "_" + name;
  }
  return name;
}

std::vector<ManifestEntry> assign_unique_names(std::vector<NamedEntry> entries) {
  std::set<std::string> used;
  std::vector<ManifestEntry> named;
  for (auto& [entry, candidates, request_index] : entries) {
    if (entry.name.empty()) entry.name = std::filesystem::path(entry.file).stem().string();
    if (entry.name.find('/') != std::string::npos || entry.name == "." || entry.name == "..") {
      throw InputError(fmt::format("{}: name: '{}' is not a valid name of an HDF5 group",
                                   entry.file, entry.name));
    }
    if (candidates.empty() && used.contains(entry.name))
      throw InputError(fmt::format("{}: name: '{}' appears twice", entry.file, entry.name));
    for (std::size_t k = 0; !candidates.empty() && (k == 0 || used.contains(entry.name)); ++k) {
      entry.name = k < candidates.size()
                       ? candidates[k]
                       : fmt::format("{}_{}", candidates[0], k - candidates.size() + 2);
    }
    used.insert(entry.name);
    named.push_back(std::move(entry));
  }
  return named;
}

}  // namespace morphe::imports
