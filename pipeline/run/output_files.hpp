#pragma once

#include <filesystem>
#include <list>
#include <vector>

#include "pipeline/run/file_lock.hpp"

namespace morphe::run {

/// The files that a command writes together, outside of an OutputFolder, and that this process
/// alone writes: .NAME.lock beside each file NAME is locked, in the order of their paths, so that
/// of two commands with common files one works.
class OutputFiles {
 public:
  /// Empty paths are left out. Throws InputError if a file is named twice, if its folder does not
  /// exist, or if another command is writing one of the files.
  explicit OutputFiles(const std::vector<std::filesystem::path>& files);

 private:
  std::list<FileLock> locks_;
};

}  // namespace morphe::run
