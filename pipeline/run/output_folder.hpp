#pragma once

#include <filesystem>
#include <vector>

namespace morphe::run {

/// The folder of a run's results, created if it is missing. If the run fails before keep(), every
/// folder on its path that was created is removed again, unless it is not empty, because another
/// run may have started in it. Throws InputError if the folder cannot be created.
class OutputFolder {
 public:
  /// Creates the folder and its missing parents.
  explicit OutputFolder(std::filesystem::path path);
  /// Removes the created folders unless keep() was called.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;
  /// Keeps the folder.
  void keep() { kept_ = true; }
  /// Returns the path of the folder.
  const std::filesystem::path& path() const { return path_; }

 private:
  void remove_made() const;

  std::filesystem::path path_;
  /// Created folders, deepest first.
  std::vector<std::filesystem::path> made_;
  bool kept_ = false;
};

}  // namespace morphe::run
