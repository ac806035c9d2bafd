#pragma once

#include <filesystem>
#include <optional>

#include "core/files/unfinished_path.hpp"

namespace morphe::run {

/// A lock file that this process alone holds, until the lock is destroyed or the process ends. The
/// file is created, and removed at the end; one that a killed process has left does not block.
class FileLock {
 public:
  /// Throws InputError "OUTPUT: another command is writing to it: …" if another process holds the
  /// file, and an InputError that names `output` if it cannot be locked. A missing folder of the
  /// file is created if `makes_folder` is true.
  FileLock(std::filesystem::path file, const std::filesystem::path& output, bool makes_folder);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
  std::optional<files::UnfinishedPath> unfinished_;
};

}  // namespace morphe::run
