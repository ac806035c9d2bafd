#pragma once

#include <filesystem>
#include <optional>

#include "core/files/unfinished_path.hpp"

namespace morphe::run {

/// A lock by which this process holds a folder until the lock is destroyed or the process ends: if
/// two processes start at the same time, only one obtains it. DIR/.lock is locked, and removed at
/// the end. The folder is created again if another process has removed it meanwhile. Throws
/// InputError if another run holds the folder or if it cannot be locked.
class FolderLock {
 public:
  /// Locks the folder.
  explicit FolderLock(const std::filesystem::path& folder);
  /// Removes the lock file and releases the lock.
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
  std::optional<files::UnfinishedPath> unfinished_;
};

}  // namespace morphe::run
