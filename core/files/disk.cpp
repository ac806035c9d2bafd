#include "core/files/disk.hpp"

#include <unistd.h>

#include <cstdio>

namespace morphe::files {
namespace {

struct RealDisk : Disk {
  std::int64_t write(int descriptor, const void* bytes, std::size_t count,
                     std::int64_t at) override {
    return ::pwrite(descriptor, bytes, count, at);
  }
  int truncate(int descriptor, std::int64_t length) override {
    return ::ftruncate(descriptor, length);
  }
  int sync(int descriptor) override { return ::fsync(descriptor); }
  int rename(const char* from, const char* to) override { return std::rename(from, to); }
};

}  // namespace

Disk& real_disk() {
  static RealDisk disk;
  return disk;
}

}  // namespace morphe::files
