// One program for all targets: MORPHE_FUZZ_TARGET names the one that libFuzzer is to try, `list`
// prints them all. scripts/fuzz runs it.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "pipeline/motion/input_error.hpp"
#include "targets.hpp"

namespace morphe::fuzz {
namespace {

std::vector<Target> all_targets() {
  std::vector<Target> all;
  for (const auto& some : {text_targets(), recording_targets(), store_targets(), verify_targets()})
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

Target chosen() {
  const char* const name = std::getenv("MORPHE_FUZZ_TARGET");
  const std::vector<Target> all = all_targets();
  const auto found = std::ranges::find(all, name ? name : "list", &Target::name);
  if (found != all.end()) return *found;
  for (const Target& target : all) fmt::print("{}\n", target.name);
  std::fflush(stdout);
  std::_Exit(name && std::string_view(name) == "list" ? 0 : 2);
}

}  // namespace

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

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const morphe::fuzz::Target target = morphe::fuzz::chosen();
  try {
    target.read({reinterpret_cast<const char*>(data), size});
  } catch (const morphe::InputError&) {
  }
  return 0;
}
