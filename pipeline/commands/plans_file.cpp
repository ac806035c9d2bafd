#include "pipeline/commands/plans_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "core/motion/input_error.hpp"
#include "core/store/sandbox_probe.hpp"
#include "pipeline/commands/shared_options.hpp"

namespace morphe::commands {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> find_plans(const fs::path& named) {
  expect_exists(named);
  if (!fs::is_directory(named)) return {named};
  if (fs::exists(named / "plans.h5")) return {named / "plans.h5"};
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(named))
    if (fs::exists(entry.path() / "plans.h5")) found.push_back(entry.path() / "plans.h5");
  std::ranges::sort(found);
  if (found.empty()) throw InputError(fmt::format("{}: contains no plans.h5", named.string()));
  return found;
}

}  // namespace

std::vector<fs::path> find_plans_files(const fs::path& named) {
  std::vector<fs::path> found = find_plans(named);
  for (const fs::path& file : found) store::probe_in_sandbox(file);
  return found;
}

fs::path find_plans_file(const fs::path& named) {
  const std::vector<fs::path> found = find_plans(named);
  if (found.size() == 1) {
    store::probe_in_sandbox(found.front());
    return found.front();
  }
  std::string list;
  for (const fs::path& file : found) list += (list.empty() ? "" : ", ") + file.string();
  throw InputError(
      fmt::format("{}: contains several plans.h5; give one of {}", named.string(), list));
}

}  // namespace morphe::commands
