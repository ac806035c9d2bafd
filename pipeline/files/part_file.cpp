#include "pipeline/files/part_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>

#include "pipeline/motion/input_error.hpp"

namespace morphe::files {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file) {
  throw InputError(fmt::format("{}: cannot be written: {}", file.string(), std::strerror(errno)));
}

void sync(const std::filesystem::path& path, Disk& disk) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) fail(path);
  const int synced = disk.sync(descriptor);
  const int error = errno;
  ::close(descriptor);
  errno = error;
  if (synced != 0) fail(path);
}

}  // namespace

PartFile::PartFile(std::filesystem::path target, Disk& disk)
    : target_(std::move(target)),
      part_(target_.string() + ".part"),
      unfinished_(part_),
      disk_(&disk) {}

PartFile::~PartFile() {
  std::error_code ignored;
  if (!committed_) std::filesystem::remove(part_, ignored);
}

void PartFile::write(const std::string& text) const {
  std::ofstream stream(part_, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw InputError(fmt::format("{}: cannot be written", target_.string()));
}

void PartFile::commit() {
  sync(part_, *disk_);
  if (disk_->rename(part_.c_str(), target_.c_str()) != 0) fail(target_);
  committed_ = true;
  sync(target_.has_parent_path() ? target_.parent_path() : std::filesystem::path("."), *disk_);
}

void write_whole(const std::filesystem::path& file, const std::string& text) {
  PartFile part(file);
  part.write(text);
  part.commit();
}

}  // namespace morphe::files
