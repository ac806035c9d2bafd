#include "core/files/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "core/motion/input_error.hpp"

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

/// Creates and opens a new file; removes a regular file that a killed process left in its place.
int create_exclusively(const std::filesystem::path& part) {
  constexpr int kMaxTries = 100;  // another process may create it again
  for (int i = 0; i < kMaxTries; ++i) {
    const int descriptor =
        ::open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor >= 0) return descriptor;
    if (errno != EEXIST) return -1;
    struct stat existing {};
    if (::lstat(part.c_str(), &existing) == 0 && !S_ISREG(existing.st_mode))
      throw InputError(
          fmt::format("{}: exists and is not a regular file; remove it", part.string()));
    ::unlink(part.c_str());
  }
  return -1;
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path target, Disk& disk)
    : target_(std::move(target)), part_(target_.string() + ".part"), disk_(&disk) {
  struct stat found {};
  if (::stat(target_.c_str(), &found) == 0 && !S_ISREG(found.st_mode))
    throw InputError(fmt::format("{}: cannot be written: is {}", target_.string(),
                                 S_ISDIR(found.st_mode) ? "a folder" : "a device, pipe or socket"));
  const auto held = hold_end();
  descriptor_ = create_exclusively(part_);
  if (descriptor_ < 0) fail(target_);
  ::fstat(descriptor_, &found);
  device_ = found.st_dev;
  inode_ = found.st_ino;
  unfinished_.emplace(part_);
}

AtomicFile::~AtomicFile() {
  std::error_code ignored;
  if (!committed_ && is_ours()) std::filesystem::remove(part_, ignored);
  close_descriptor();
}

void AtomicFile::close_descriptor() {
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
}

bool AtomicFile::is_ours() const {
  struct stat found {};
  return ::lstat(part_.c_str(), &found) == 0 && found.st_dev == device_ && found.st_ino == inode_;
}

std::ofstream AtomicFile::open_stream() const {
  const auto held = hold_end();
  return std::ofstream(part_, std::ios::binary);
}

void AtomicFile::write(const std::string& text) {
  std::ofstream stream = open_stream();
  stream << text;
  stream.close();
  close_descriptor();  // thousands of files may wait for commit(), more than may be open
  if (!stream) throw InputError(fmt::format("{}: cannot be written", target_.string()));
}

void AtomicFile::commit() {
  if (!is_ours()) throw InputError(target_.string() + ": another process is writing it");
  sync(part_, *disk_);
  if (disk_->rename(part_.c_str(), target_.c_str()) != 0) fail(target_);
  committed_ = true;
  close_descriptor();
  sync(target_.has_parent_path() ? target_.parent_path() : std::filesystem::path("."), *disk_);
}

void expect_not_input(const std::filesystem::path& out, const std::filesystem::path& input) {
  std::error_code error;
  if (!out.empty() && std::filesystem::equivalent(out, input, error) && !error)
    throw InputError(
        fmt::format("{}: is an input file; writing it would replace it", out.string()));
}

void write_atomically(const std::filesystem::path& file, const std::string& text) {
  AtomicFile part(file);
  part.write(text);
  part.commit();
}

}  // namespace morphe::files
