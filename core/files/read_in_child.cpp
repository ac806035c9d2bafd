#include "core/files/read_in_child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <new>
#include <system_error>

#include "core/files/sandbox.hpp"
#include "core/motion/input_error.hpp"

namespace morphe::files {
namespace {

constexpr int kExitDone = 0, kExitOutOfMemory = 3, kExitException = 4;

struct Limits {
  std::uint64_t seconds, bytes;
};

int exit_code(const std::function<void()>& read) {
  try {
    read();
  } catch (const InputError&) {
  } catch (const std::bad_alloc&) {
    return kExitOutOfMemory;
  } catch (...) {
    return kExitException;
  }
  return kExitDone;
}

/// Returns how much memory this process may take [bytes].
std::uint64_t memory_limit() {
  rlimit limit{};
  return ::getrlimit(RLIMIT_AS, &limit) == 0 ? limit.rlim_cur : RLIM_INFINITY;
}

[[noreturn]] void read_and_exit(const std::function<void()>& read, const Limits& limits) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int null_device = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(null_device, stream);
  enter_read_sandbox(limits.seconds, limits.bytes);
  ::_exit(exit_code(read));
}

std::string exit_error(int status, const Limits& limits) {
  if (WIFEXITED(status)) {
    const int code = WEXITSTATUS(status);
    if (code == kExitOutOfMemory && memory_limit() < limits.bytes) throw std::bad_alloc();
    if (code == kExitOutOfMemory)
      return fmt::format("reading it takes more than {} MB of memory", limits.bytes >> 20);
    return code == kExitDone ? "" : "the library that reads it fails";
  }
  const int signal = WTERMSIG(status);
  if (signal == SIGXCPU || signal == SIGKILL)
    return fmt::format("reading it takes more than {} s", limits.seconds);
  return fmt::format("the library that reads it crashes ({})", ::strsignal(signal));
}

}  // namespace

std::string child_read_error(const std::filesystem::path& file, const std::function<void()>& read) {
  std::error_code error;
  std::uintmax_t bytes = std::filesystem::file_size(file, error);
  return child_read_error(error ? 0 : bytes, read);
}

std::string child_read_error(std::uintmax_t file_bytes, const std::function<void()>& read) {
  const Limits limits{10 + (file_bytes >> 20), (std::uint64_t{1} << 30) + 32 * file_bytes};
  const pid_t child = ::fork();
  if (child < 0)
    throw std::system_error(errno, std::generic_category(), "cannot start a process to read files");
  if (child == 0) read_and_exit(read, limits);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  return exit_error(status, limits);
}

}  // namespace morphe::files
