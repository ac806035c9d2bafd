#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "core/files/disk.hpp"
#include "core/files/unfinished_path.hpp"

namespace morphe::files {

/// A file that appears under its name only when it is complete: it is written as "<name>.part" in
/// the same folder, then synced and renamed. It is removed if commit() is never called, also if a
/// signal ends the process. The constructor creates the part file, empty, and replaces one that a
/// killed process has left; links are not followed. Throws InputError if the name or the part file
/// is a folder, a device or another object that is not a regular file, or if the part file cannot
/// be created.
class AtomicFile {
 public:
  /// Creates the part file.
  explicit AtomicFile(std::filesystem::path target, Disk& disk = real_disk());
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  /// Returns the path of the complete file.
  const std::filesystem::path& target() const { return target_; }
  /// Returns the path of the part file.
  const std::filesystem::path& part() const { return part_; }
  /// Writes a text to the part file; throws InputError on failure.
  void write(const std::string& text);
  /// Syncs and renames the part file, which must be closed. Throws InputError if that fails, or if
  /// another process has replaced the part file.
  void commit();

 private:
  bool is_ours() const;
  void close_descriptor();

  std::filesystem::path target_, part_;
  Disk* disk_;
  /// Descriptor of the part file until its text is written, so that no other file gets its inode
  /// number.
  int descriptor_ = -1;
  std::uint64_t device_ = 0, inode_ = 0;
  std::optional<UnfinishedPath> unfinished_;
  bool committed_ = false;
};

/// Throws InputError if an output file is also an input file.
void expect_not_input(const std::filesystem::path& out, const std::filesystem::path& input);

/// Writes a file atomically: completely or not at all. Throws InputError if it cannot be written.
void write_atomically(const std::filesystem::path& file, const std::string& text);

}  // namespace morphe::files
