#include "core/files/unfinished_path.hpp"

#include <algorithm>
#include <mutex>
#include <system_error>
#include <utility>
#include <vector>

namespace morphe::files {
namespace {

/// The list is never destroyed, because a signal may arrive while the process ends.
struct UnfinishedPathList {
  std::recursive_mutex mutex;  // a library may end the process inside hold_end()
  std::vector<std::filesystem::path> paths;
};

UnfinishedPathList& unfinished_paths() {
  static auto* const all = new UnfinishedPathList;
  return *all;
}

}  // namespace

UnfinishedPath::UnfinishedPath(std::filesystem::path path) : path_(std::move(path)) {
  const std::lock_guard lock(unfinished_paths().mutex);
  unfinished_paths().paths.push_back(path_);
}

UnfinishedPath::~UnfinishedPath() {
  const std::lock_guard lock(unfinished_paths().mutex);
  auto& paths = unfinished_paths().paths;
  paths.erase(std::ranges::find(paths, path_));
}

std::unique_lock<std::recursive_mutex> hold_end() {
  return std::unique_lock(unfinished_paths().mutex);
}

void remove_unfinished_paths() {
  unfinished_paths().mutex.lock();  // until the process ends
  std::error_code ignored;
  for (const auto& path : unfinished_paths().paths) std::filesystem::remove_all(path, ignored);
}

}  // namespace morphe::files
