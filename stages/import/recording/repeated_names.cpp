#include "stages/import/recording/repeated_names.hpp"

#include <fmt/format.h>

#include <set>

namespace morphe::imports {

void number_repeated_names(std::vector<std::string>& names, std::vector<std::string>& notes) {
  std::set<std::string> all(names.begin(), names.end()), known;
  if (all.size() == names.size()) return;
  for (std::string& name : names) {
    if (known.insert(name).second) continue;
    std::string numbered;
    for (int n = 2; numbered.empty() || all.contains(numbered); ++n)
      numbered = fmt::format("{}_{}", name, n);
    notes.push_back(
        fmt::format("the name {} stands more than once; another is called {}", name, numbered));
    name = numbered;
    all.insert(numbered);
    known.insert(numbered);
  }
}

}  // namespace morphe::imports
