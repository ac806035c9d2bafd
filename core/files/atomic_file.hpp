#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "core/files/disk.hpp"
#include "core/files/unfinished_path.hpp"

namespace morphe::files {

/// A file that appears under its name only when it is complete. It is written as "<name>.part" in
/// the same folder; commit() syncs and renames it. Without commit(), also if a signal ends the
/// process, the part file is removed. The constructor creates the part file, in place of one that a
/// killed process has left; links are not followed. It throws InputError if that fails, or if the
/// name or the part file is a folder, device or other irregular file.
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
  /// Opens the part file, which loses its content; the stream's state tells whether that failed.
  std::ofstream open_stream() const;
  /// Replaces the content of the part file by a text; throws InputError on failure.
  void write(const std::string& text);
  /// Syncs and renames the part file; throws InputError also if another process replaced it.
  void commit();

 private:
  bool is_ours() const;
  void close_descriptor();

  std::filesystem::path target_, part_;
  Disk* disk_;
  int descriptor_ = -1;  ///< open until the text is written, so that its inode is not reused
  std::uint64_t device_ = 0, inode_ = 0;
  std::optional<UnfinishedPath> unfinished_;
  bool committed_ = false;
};

/// Throws InputError if both paths lead to the same existing file; `out` may be "".
void expect_not_input(const std::filesystem::path& out, const std::filesystem::path& input);

/// Writes a file atomically: completely or not at all. Throws InputError if it cannot be written.
void write_atomically(const std::filesystem::path& file, const std::string& text);

}  // namespace morphe::files
