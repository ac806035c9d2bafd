#pragma once

#include <filesystem>
#include <string>

#include "pipeline/files/disk.hpp"
#include "pipeline/files/unfinished.hpp"

namespace morphe::files {

/// A file that appears under its name only when it is whole: written beside it as "<name>.part",
/// then synced and renamed. Removed again if commit() is never reached, also when a signal ends the
/// process.
class PartFile {
 public:
  explicit PartFile(std::filesystem::path target, Disk& disk = real_disk());
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  ~PartFile();

  const std::filesystem::path& target() const { return target_; }
  const std::filesystem::path& part() const { return part_; }
  /// The part file, of that text. InputError if it cannot be written.
  void write(const std::string& text) const;
  /// The file must be closed. InputError if it cannot be brought to the disk or renamed.
  void commit();

 private:
  std::filesystem::path target_, part_;
  Unfinished unfinished_;
  Disk* disk_;
  bool committed_ = false;
};

/// A file of that text, whole or not at all. InputError if it cannot be written.
void write_whole(const std::filesystem::path& file, const std::string& text);

}  // namespace morphe::files
