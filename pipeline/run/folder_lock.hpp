#pragma once

#include <filesystem>
#include <optional>

#include "core/files/unfinished.hpp"

namespace morphe::run {

/// Holds a folder for this process alone until it is destroyed or the process ends: of two that
/// begin at once, one gets it. DIR/.lock is locked, and taken away in the end. The folder is made
/// again if another process took it away meanwhile. InputError: another run is at work in it, or it
/// cannot be locked.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
  std::optional<files::Unfinished> unfinished_;
};

}  // namespace morphe::run
