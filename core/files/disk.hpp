#pragma once

#include <cstddef>
#include <cstdint>

namespace morphe::files {

/// The system calls for writing a file, as an interface so that tests can use a disk that fails:
/// pwrite, ftruncate, fsync and rename, with their return values and errno.
struct Disk {
  virtual ~Disk() = default;
  /// Writes bytes at the offset `at`, like pwrite().
  virtual std::int64_t write(int file, const void* bytes, std::size_t count, std::int64_t at) = 0;
  /// Sets the length of a file, like ftruncate().
  virtual int truncate(int file, std::int64_t length) = 0;
  /// Flushes a file to the disk, like fsync().
  virtual int sync(int file) = 0;
  /// Renames a file, like rename().
  virtual int rename(const char* from, const char* to) = 0;
};

/// Returns the disk that calls the system.
Disk& real_disk();

}  // namespace morphe::files
