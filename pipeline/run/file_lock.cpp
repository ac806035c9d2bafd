#include "pipeline/run/file_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "core/motion/input_error.hpp"

namespace morphe::run {
namespace {

/// Locks the file, without waiting, for this descriptor and not for the process: the lock ends when
/// the descriptor is closed. Returns false if the file is locked already or cannot be.
bool lock_file(int descriptor) {
  struct flock whole_file {};
  whole_file.l_type = F_WRLCK;
  whole_file.l_whence = SEEK_SET;
  return ::fcntl(descriptor, F_OFD_SETLK, &whole_file) == 0;
}

/// Returns true if the path still names the open file: its previous holder may have removed it.
bool is_same_file(const std::filesystem::path& file, int descriptor) {
  struct stat named {
  }, open{};
  return ::fstat(descriptor, &open) == 0 && ::lstat(file.c_str(), &named) == 0 &&
         named.st_dev == open.st_dev && named.st_ino == open.st_ino;
}

}  // namespace

FileLock::FileLock(std::filesystem::path file, const std::filesystem::path& output,
                   bool makes_folder)
    : file_(std::move(file)) {
  constexpr int kMaxLockAttempts = 1000;
  std::error_code not_created;
  for (int i = 0; i < kMaxLockAttempts; ++i) {
    const auto held = files::hold_end();
    if (makes_folder) std::filesystem::create_directories(file_.parent_path(), not_created);
    descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && errno == ENOENT && makes_folder) continue;
    if (descriptor_ < 0) break;
    const bool locked = lock_file(descriptor_);
    const int error = errno;
    if (locked && is_same_file(file_, descriptor_)) {
      unfinished_.emplace(file_);
      return;
    }
    ::close(descriptor_);
    errno = error;
    if (locked) continue;
    if (error == EAGAIN || error == EACCES)
      throw InputError(
          fmt::format("{}: another command is writing to it: wait until it has ended, or give "
                      "another output",
                      output.string()));
    break;
  }
  if (not_created)
    throw InputError(
        fmt::format("{}: cannot be created: {}", output.string(), not_created.message()));
  throw InputError(fmt::format("{}: cannot be written: {}", output.string(), std::strerror(errno)));
}

FileLock::~FileLock() {
  // If somebody removed the file, another process may hold the output with a new one.
  if (is_same_file(file_, descriptor_)) ::unlink(file_.c_str());
  ::close(descriptor_);
}

}  // namespace morphe::run
