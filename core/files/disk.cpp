#include "core/files/disk.hpp"

#include <unistd.h>

#include <cstdio>

namespace morphe::files {
namespace {

struct RealDisk : Disk {
  std::int64_t write(int file, const void* bytes, std::size_t count, std::int64_t at) override {
    return ::pwrite(file, bytes, count, at);
  }
  int truncate(int file, std::int64_t length) override { return ::ftruncate(file, length); }
  int sync(int file) override { return ::fsync(file); }
  int rename(const char* from, const char* to) override { return std::rename(from, to); }
};

}  // namespace

Disk& real_disk() {
  static RealDisk disk;
  return disk;
}

}  // namespace morphe::files
