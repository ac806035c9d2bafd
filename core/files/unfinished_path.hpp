#pragma once

#include <filesystem>

namespace morphe::files {

/// A file or folder that must not outlive the process unfinished: while this object exists, a
/// signal that ends the process removes the file or folder (remove_unfinished_paths()). The list of
/// these objects is global, because signals concern the whole process.
class UnfinishedPath {
 public:
  explicit UnfinishedPath(std::filesystem::path path);
  ~UnfinishedPath();
  UnfinishedPath(const UnfinishedPath&) = delete;
  UnfinishedPath& operator=(const UnfinishedPath&) = delete;

 private:
  std::filesystem::path path_;
};

/// Removes all unfinished files and folders; for any thread, but not for a signal handler.
void remove_unfinished_paths();

}  // namespace morphe::files
