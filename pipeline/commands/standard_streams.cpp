#include "pipeline/commands/standard_streams.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>
#include <string>
#include <string_view>

#include "core/files/printable.hpp"

namespace morphe::commands {
namespace {

constexpr int kOutputErrorExitCode = 2;
constexpr std::string_view kClearLine = "\r\033[K";  ///< as in pipeline/run/status_line.cpp

struct GuardedStream {
  int descriptor;
  int error = 0;        ///< errno of the first write that failed
  std::string pending;  ///< the first bytes of an incomplete character
};

void write_all(GuardedStream& stream, std::string_view bytes) {
  while (!bytes.empty() && stream.error == 0) {
    const ssize_t written = ::write(stream.descriptor, bytes.data(), bytes.size());
    if (written >= 0) {
      bytes.remove_prefix(written);
    } else if (errno != EINTR) {
      stream.error = errno;
    }
  }
}

std::string escape_controls(std::string_view text) {
  std::string out;
  for (std::size_t begin = 0; (begin = text.find(kClearLine)) != std::string_view::npos;) {
    out += files::make_printable(text.substr(0, begin), "\n\t");
    out += kClearLine;
    text.remove_prefix(begin + kClearLine.size());
  }
  return out + files::make_printable(text, "\n\t");
}

/// Writes to a stream as fopencookie() requires, and always reports that all bytes were accepted.
ssize_t write_guarded(void* cookie, const char* bytes, std::size_t count) {
  GuardedStream& stream = *static_cast<GuardedStream*>(cookie);
  try {
    std::string text = std::move(stream.pending) + std::string(bytes, count);
    const std::size_t rest = files::incomplete_utf8_bytes(text);
    stream.pending = text.substr(text.size() - rest);
    text.resize(text.size() - rest);
    write_all(stream, escape_controls(text));
  } catch (const std::bad_alloc&) {  // must not pass through the C library
    if (stream.error == 0) stream.error = ENOMEM;
  }
  return static_cast<ssize_t>(count);
}

GuardedStream& out() {
  static GuardedStream stream{STDOUT_FILENO, 0, {}};
  return stream;
}

GuardedStream& err() {
  static GuardedStream stream{STDERR_FILENO, 0, {}};
  return stream;
}

/// Makes `stream`, a variable of the GNU C library for stdout or stderr, write to a guarded stream.
void guard_stream(FILE*& stream, GuardedStream& target, int buffering) {
  const cookie_io_functions_t functions{nullptr, write_guarded, nullptr, nullptr};
  FILE* const guarded = ::fopencookie(&target, "w", functions);
  if (!guarded) return;
  std::setvbuf(guarded, nullptr, buffering, BUFSIZ);
  stream = guarded;
}

}  // namespace

void guard_standard_streams() {
  // A closed descriptor is opened in the wrong direction, so that using it fails as before.
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(descriptor, F_GETFD) >= 0) continue;
    if (::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY) != descriptor) return;
  }
  std::signal(SIGPIPE, SIG_IGN);
  guard_stream(stdout, out(), ::isatty(STDOUT_FILENO) == 1 ? _IOLBF : _IOFBF);
  guard_stream(stderr, err(), _IONBF);
}

int flush_standard_output(int code) {
  std::fflush(stdout);
  write_all(out(), files::make_printable(out().pending));
  out().pending.clear();
  const int error = out().error;
  if (error == 0) return code;
  if (error != EPIPE)
    fmt::print(stderr, "standard output: cannot be written: {}\n", std::strerror(error));
  return kOutputErrorExitCode;
}

}  // namespace morphe::commands
