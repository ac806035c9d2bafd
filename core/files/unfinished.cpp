#include "core/files/unfinished.hpp"

#include <algorithm>
#include <mutex>
#include <system_error>
#include <utility>
#include <vector>

namespace morphe::files {
namespace {

/// Never destroyed: a signal may come while the process ends.
struct UnfinishedPaths {
  std::mutex mutex;
  std::vector<std::filesystem::path> paths;
};

UnfinishedPaths& unfinished() {
  static auto* const all = new UnfinishedPaths;
  return *all;
}

}  // namespace

Unfinished::Unfinished(std::filesystem::path path) : path_(std::move(path)) {
  const std::lock_guard lock(unfinished().mutex);
  unfinished().paths.push_back(path_);
}

Unfinished::~Unfinished() {
  const std::lock_guard lock(unfinished().mutex);
  auto& paths = unfinished().paths;
  paths.erase(std::ranges::find(paths, path_));
}

void remove_unfinished() {
  const std::lock_guard lock(unfinished().mutex);
  std::error_code ignored;
  for (const std::filesystem::path& path : unfinished().paths)
    std::filesystem::remove_all(path, ignored);
}

}  // namespace morphe::files
