#include "stages/import/recording/apply_name_map.hpp"

#include <fmt/format.h>

#include <set>

#include "core/motion/input_error.hpp"

namespace morphe::imports {

void apply_name_map(const std::string& file, const std::map<std::string, std::string>& renamed,
                    std::vector<std::string>& names) {
  std::set<std::string> mapped, resulting;
  for (std::string& name : names) {
    if (const auto entry = renamed.find(name); entry != renamed.end()) {
      mapped.insert(name);
      name = entry->second;
    }
    if (!resulting.insert(name).second)
      throw InputError(fmt::format("{}: names: two names are mapped to '{}'", file, name));
  }
  for (const auto& [recorded, name] : renamed) {
    if (mapped.contains(recorded)) continue;
    throw InputError(fmt::format("{}: names: '{}' is to be renamed but is not in the recording",
                                 file, recorded));
  }
}

}  // namespace morphe::imports
