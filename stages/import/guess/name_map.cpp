#include "stages/import/guess/name_map.hpp"

#include <algorithm>
#include <set>

#include "core/config/node.hpp"
#include "core/files/shipped.hpp"
#include "core/motion/input_error.hpp"

namespace morphe::imports {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFolder = "configs/names";

/// Those that are there and are maps: nobody asked for them by name.
std::vector<ShippedNames> shipped_maps() {
  std::vector<fs::path> named;
  std::error_code ignored;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(files::here_or_shipped(kFolder), ignored)) {
    if (entry.path().extension() == ".yaml") named.push_back(entry.path().filename());
  }
  std::ranges::sort(named);
  std::vector<ShippedNames> maps;
  for (const fs::path& name : named) {
    try {
      const fs::path file = kFolder / name;
      maps.push_back({file, read_names(files::here_or_shipped(file))});
    } catch (const InputError&) {
      continue;
    }
  }
  return maps;
}

}  // namespace

NameMap read_names(const fs::path& file) {
  NameMap names;
  if (file.empty()) return names;
  const config::ConfigNode root = config::ConfigNode::load(file);
  if (!root.is_map()) root.fail("must map recorded marker names to names");
  for (const std::string& key : root.keys()) names[key] = root[key].text();
  return names;
}

std::optional<ShippedNames> shipped_names_for(const std::vector<std::string>& recorded) {
  const std::set<std::string> there(recorded.begin(), recorded.end());
  std::optional<ShippedNames> best;
  bool tied = false;
  for (ShippedNames& candidate : shipped_maps()) {
    const bool fits = std::ranges::all_of(
        candidate.names, [&](const auto& entry) { return there.contains(entry.first); });
    if (!fits || candidate.names.empty()) continue;
    const std::size_t size = best ? best->names.size() : 0;
    if (candidate.names.size() == size) tied = true;
    if (candidate.names.size() <= size) continue;
    best = std::move(candidate);
    tied = false;
  }
  return tied ? std::nullopt : best;
}

}  // namespace morphe::imports
