#include "pipeline/commands/standard_streams.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <string>
#include <string_view>

#include "core/files/printable.hpp"

namespace morphe::commands {
namespace {

constexpr int kBadOutput = 2;
constexpr std::string_view kClearLine = "\r\033[K";  ///< pipeline/run/status_line.cpp

/// What stands behind one of the two streams.
struct Guarded {
  int descriptor;
  int error = 0;        ///< errno of the first write that failed
  std::string pending;  ///< the first bytes of a letter
};

void write_all(Guarded& stream, std::string_view bytes) {
  while (!bytes.empty() && stream.error == 0) {
    const ssize_t put = ::write(stream.descriptor, bytes.data(), bytes.size());
    if (put >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(put));
    } else if (errno != EINTR) {
      stream.error = errno;
    }
  }
}

std::string shown(std::string_view text) {
  std::string out;
  for (std::size_t at = 0; (at = text.find(kClearLine)) != std::string_view::npos;) {
    out += files::printable(text.substr(0, at), "\n\t");
    out += kClearLine;
    text.remove_prefix(at + kClearLine.size());
  }
  return out + files::printable(text, "\n\t");
}

/// As fopencookie() asks for it; says that everything was taken.
ssize_t write_guarded(void* cookie, const char* bytes, std::size_t count) {
  Guarded& stream = *static_cast<Guarded*>(cookie);
  std::string text = std::move(stream.pending) + std::string(bytes, count);
  const std::size_t rest = files::unfinished_letter(text);
  stream.pending = text.substr(text.size() - rest);
  text.resize(text.size() - rest);
  write_all(stream, shown(text));
  return static_cast<ssize_t>(count);
}

Guarded& out() {
  static Guarded stream{STDOUT_FILENO, 0, {}};
  return stream;
}

Guarded& err() {
  static Guarded stream{STDERR_FILENO, 0, {}};
  return stream;
}

/// `stdout` and `stderr` are variables in the GNU C library.
void replace(FILE*& stream, Guarded& by, int buffering) {
  const cookie_io_functions_t functions{nullptr, write_guarded, nullptr, nullptr};
  FILE* const guarded = ::fopencookie(&by, "w", functions);
  if (!guarded) return;
  std::setvbuf(guarded, nullptr, buffering, BUFSIZ);
  stream = guarded;
}

}  // namespace

void guard_standard_streams() {
  // One that was closed is opened the wrong way round, so that using it fails as it did.
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(descriptor, F_GETFD) >= 0) continue;
    if (::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY) != descriptor) return;
  }
  std::signal(SIGPIPE, SIG_IGN);
  replace(stdout, out(), ::isatty(STDOUT_FILENO) == 1 ? _IOLBF : _IOFBF);
  replace(stderr, err(), _IONBF);
}

int after_standard_output(int code) {
  std::fflush(stdout);
  write_all(out(), files::printable(out().pending));
  out().pending.clear();
  const int error = out().error;
  if (error == 0) return code;
  if (error != EPIPE)
    fmt::print(stderr, "standard output: cannot be written: {}\n", std::strerror(error));
  return kBadOutput;
}

}  // namespace morphe::commands
