#pragma once

#include <filesystem>
#include <mutex>

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

/// Keeps the process from ending by a signal while a file is created and listed: a file created
/// without it may appear after the unfinished ones were removed, and stay.
[[nodiscard]] std::unique_lock<std::recursive_mutex> hold_end();

/// Removes all unfinished files and folders, for a process that ends now; for any thread, but not
/// for a signal handler. From then on any other thread waits that creates such a file or finishes
/// one (hold_end(), UnfinishedPath): it does not come to report that its file is gone.
void remove_unfinished_paths();

}  // namespace morphe::files
