#include "stages/import/guess/name_map.hpp"

#include <algorithm>
#include <set>

#include "core/config/node.hpp"
#include "core/files/data_files.hpp"
#include "core/motion/input_error.hpp"

namespace morphe::imports {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFolder = "configs/names";

/// Returns the maps in configs/names. Invalid files are ignored, since the user did not name them.
std::vector<ShippedNameMap> shipped_maps() {
  std::vector<ShippedNameMap> maps;
  for (const fs::path& file : shipped_name_files()) {
    try {
      maps.push_back({kFolder / file.filename(), read_names(file)});
    } catch (const InputError&) {
      continue;
    }
  }
  return maps;
}

}  // namespace

std::vector<fs::path> shipped_name_files() {
  std::vector<fs::path> files;
  std::error_code ignored;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(files::resolve_data_file(kFolder), ignored)) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

NameMap read_names(const fs::path& file) {
  NameMap names;
  if (file.empty()) return names;
  const config::ConfigNode root = config::ConfigNode::load(file);
  if (!root.is_map()) root.fail("must map recorded marker names to names");
  for (const std::string& key : root.keys()) names[key] = root[key].text();
  return names;
}

std::optional<ShippedNameMap> find_shipped_names(const std::vector<std::string>& recorded) {
  const std::set<std::string> names(recorded.begin(), recorded.end());
  std::optional<ShippedNameMap> largest;
  bool tied = false;
  for (ShippedNameMap& candidate : shipped_maps()) {
    const bool fits = std::ranges::all_of(
        candidate.names, [&](const auto& entry) { return names.contains(entry.first); });
    if (!fits || candidate.names.empty()) continue;
    const std::size_t size = largest ? largest->names.size() : 0;
    if (candidate.names.size() == size) tied = true;
    if (candidate.names.size() <= size) continue;
    largest = std::move(candidate);
    tied = false;
  }
  return tied ? std::nullopt : largest;
}

}  // namespace morphe::imports
