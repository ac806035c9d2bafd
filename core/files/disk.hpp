#pragma once

#include <cstddef>
#include <cstdint>

namespace morphe::files {

/// What writing a file asks of the system, so that a test can have a disk that fails: pwrite,
/// ftruncate, fsync and rename, with their return values and errno.
struct Disk {
  virtual ~Disk() = default;
  virtual std::int64_t write(int descriptor, const void* bytes, std::size_t count,
                             std::int64_t at) = 0;
  virtual int truncate(int descriptor, std::int64_t length) = 0;
  virtual int sync(int descriptor) = 0;
  virtual int rename(const char* from, const char* to) = 0;
};

/// The system's own.
Disk& real_disk();

}  // namespace morphe::files
