#include "targets.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

namespace morphe::fuzz {

std::vector<Target> all_targets() {
  std::vector<Target> all;
  for (const auto& some : {text_targets(), recording_targets(), store_targets(), verify_targets()})
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

std::optional<Target> target_named(std::string_view name) {
  const std::vector<Target> all = all_targets();
  const auto found = std::ranges::find(all, name, &Target::name);
  return found == all.end() ? std::nullopt : std::optional(*found);
}

std::filesystem::path as_file(std::string_view bytes, const std::string& name) {
  // Never destroyed: it is taken away at the very end.
  static const auto* const folder = [] {
    auto* const made = new std::filesystem::path(std::filesystem::temp_directory_path() /
                                                 fmt::format("morphe_fuzz_{}", ::getpid()));
    std::filesystem::create_directories(*made);
    std::atexit([] { std::filesystem::remove_all(as_file("", "last").parent_path()); });
    return made;
  }();
  std::ofstream(*folder / name, std::ios::binary)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return *folder / name;
}

}  // namespace morphe::fuzz
