#include "pipeline/run/status_line.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace morphe::run {
namespace {

constexpr const char* kClearLineSequence = "\r\033[K";

bool rewrites_lines() {
  const char* const kind = std::getenv("TERM");
  return ::isatty(STDERR_FILENO) == 1 && !(kind && std::string_view(kind) == "dumb");
}

/// Returns as much of the text as fits on one line. A character of several bytes is not split.
std::string truncate_to_width(const std::string& text) {
  winsize size{};
  if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return text;
  const auto begins_letter = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
  std::size_t letters = 0, end = 0;
  while (end < text.size() && (letters += begins_letter(text[end]) ? 1 : 0) < size.ws_col) ++end;
  return text.substr(0, end);
}

}  // namespace

StatusLine::StatusLine() : terminal_(rewrites_lines()) {}

void StatusLine::show(const std::string& text) {
  if (!terminal_) return;
  const std::lock_guard lock(mutex_);
  fmt::print(stderr, "{}{}", kClearLineSequence, truncate_to_width(text));
  std::fflush(stderr);
  shown_ = true;
}

void StatusLine::clear() {
  const std::lock_guard lock(mutex_);
  if (shown_) fmt::print(stderr, "{}", kClearLineSequence);
  std::fflush(stderr);
  shown_ = false;
}

void StatusLine::print(const std::string& text) {
  const std::lock_guard lock(mutex_);
  fmt::print(stderr, "{}{}\n", terminal_ ? kClearLineSequence : "", text);
  std::fflush(stderr);
  shown_ = false;
}

}  // namespace morphe::run
