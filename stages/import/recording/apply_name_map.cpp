#include "stages/import/recording/apply_name_map.hpp"

#include <fmt/format.h>

#include <set>

#include "core/motion/input_error.hpp"

namespace morphe::imports {

void apply_name_map(const std::string& file, const std::map<std::string, std::string>& renamed,
                    std::vector<std::string>& names) {
  std::set<std::string> used, known;
  for (std::string& name : names) {
    if (const auto entry = renamed.find(name); entry != renamed.end()) {
      used.insert(name);
      name = entry->second;
    }
    if (!known.insert(name).second) {
      throw InputError(fmt::format("{}: names: two names are mapped to '{}'", file, name));
    }
  }
  for (const auto& entry : renamed) {
    if (!used.contains(entry.first)) {
      throw InputError(fmt::format("{}: names: '{}' is to be renamed but is not in the recording",
                                   file, entry.first));
    }
  }
}

}  // namespace morphe::imports
