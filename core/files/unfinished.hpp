#pragma once

#include <filesystem>

namespace morphe::files {

/// A file or folder that must not outlive the process half done. While this lives, a signal that
/// ends the process takes it away (remove_unfinished()). A signal is the process's, so is the list
/// of these.
class Unfinished {
 public:
  explicit Unfinished(std::filesystem::path path);
  ~Unfinished();
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;

 private:
  std::filesystem::path path_;
};

/// Takes away every unfinished file and folder: the process is about to end. From any thread, but
/// not from a signal handler.
void remove_unfinished();

}  // namespace morphe::files
