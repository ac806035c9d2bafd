#pragma once

#include <filesystem>
#include <vector>

namespace morphe::run {

/// The folder of a run's results. The constructor creates all missing folders on its path; it
/// throws InputError if this fails. Without keep(), the destructor removes the created folders that
/// are empty. Others may be in use by another run.
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
  bool kept_ = false;
};

}  // namespace morphe::run
