#pragma once

#include <filesystem>
#include <vector>

namespace morphe::run {

/// The folder of a run's results, made where it is missing. If the run fails before keep(), every
/// folder on its path that did not exist before is taken away again, unless it holds something:
/// another run may have come into it. InputError if it cannot be made.
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
  std::vector<std::filesystem::path> made_;  ///< deepest first
  bool kept_ = false;
};

}  // namespace morphe::run
