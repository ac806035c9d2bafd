#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "pipeline/run/file_lock.hpp"

namespace morphe::run {

/// The folder of a command's results, which this process alone writes: DIR/.lock is locked. The
/// constructor creates all missing folders on its path; it throws InputError if this fails or
/// another command is writing to the folder. Without keep(), the destructor removes the created
/// folders that are empty. Others may be in use by another command.
class OutputFolder {
 public:
  explicit OutputFolder(std::filesystem::path path);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;
  void keep() { kept_ = true; }
  const std::filesystem::path& path() const { return path_; }

 private:
  void remove_made() const;

  std::filesystem::path path_;
  std::vector<std::filesystem::path> made_;  ///< created folders, deepest first
  std::optional<FileLock> lock_;
  bool kept_ = false;
};

}  // namespace morphe::run
