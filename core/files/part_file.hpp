#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "core/files/disk.hpp"
#include "core/files/unfinished.hpp"

namespace morphe::files {

/// A file that appears under its name only when it is whole: written beside it as "<name>.part",
/// then synced and renamed. Removed again if commit() is never reached, also when a signal ends the
/// process. The part file is made here, empty, in the place of one that a killed process left;
/// links are not followed. InputError: the name is that of a folder, a device or another thing that
/// is no file, or the part file is, or cannot be made.
class PartFile {
 public:
  explicit PartFile(std::filesystem::path target, Disk& disk = real_disk());
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  ~PartFile();

  const std::filesystem::path& target() const { return target_; }
  const std::filesystem::path& part() const { return part_; }
  /// The part file, of that text. InputError if it cannot be written.
  void write(const std::string& text);
  /// The file must be closed. InputError if it cannot be brought to the disk or renamed, or if
  /// another process has put its own in the place of the part file.
  void commit();

 private:
  bool is_ours() const;
  void let_go();

  std::filesystem::path target_, part_;
  Disk* disk_;
  int descriptor_ = -1;  ///< of the part file until its text is written: no other gets its number
  std::uint64_t device_ = 0, inode_ = 0;
  std::optional<Unfinished> unfinished_;
  bool committed_ = false;
};

/// InputError if a file that is to be written is one that is read.
void expect_no_input(const std::filesystem::path& out, const std::filesystem::path& input);

/// A file of that text, whole or not at all. InputError if it cannot be written.
void write_whole(const std::filesystem::path& file, const std::string& text);

}  // namespace morphe::files
