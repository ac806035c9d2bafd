// One program for all targets: MORPHE_FUZZ_TARGET names the one that libFuzzer is to try, `list`
// prints them all. scripts/fuzz runs it.
#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "core/motion/input_error.hpp"
#include "targets.hpp"

namespace morphe::fuzz {
namespace {

Target chosen() {
  const char* const asked = std::getenv("MORPHE_FUZZ_TARGET");
  const std::string name = asked ? asked : "";
  if (std::optional<Target> target = target_named(name)) return *target;
  for (const Target& target : all_targets()) fmt::print("{}\n", target.name);
  std::fflush(stdout);
  std::_Exit(name == "list" ? 0 : 2);
}

}  // namespace
}  // namespace morphe::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const morphe::fuzz::Target target = morphe::fuzz::chosen();
  try {
    target.read({reinterpret_cast<const char*>(data), size});
  } catch (const morphe::InputError&) {
  }
  return 0;
}
