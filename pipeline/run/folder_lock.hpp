#pragma once

#include <filesystem>
#include <optional>

#include "core/files/unfinished_path.hpp"

namespace morphe::run {

/// A lock by which this process alone holds a folder, until the lock is destroyed or the process
/// ends. The file DIR/.lock is locked, and removed at the end. A missing folder is created. Throws
/// InputError if another process holds the folder or it cannot be locked.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
  std::optional<files::UnfinishedPath> unfinished_;
};

}  // namespace morphe::run
