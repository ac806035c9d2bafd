#pragma once

#include <mutex>
#include <string>

namespace morphe::run {

/// The last line of a terminal, on standard error, which shows progress. It is rewritten in place
/// and removed before other text is printed, so that neither results nor errors are appended to it.
/// It is never wider than the terminal. If standard error is a file or a pipe, no status line is
/// shown. It is safe to use from several threads.
class StatusLine {
 public:
  StatusLine();
  ~StatusLine() { clear(); }
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  /// Returns true if standard error is a terminal.
  bool on_terminal() const { return terminal_; }
  /// Replaces the text of the status line.
  void show(const std::string& text);
  /// Removes the status line.
  void clear();
  /// Prints a permanent line, also to a file or pipe.
  void print(const std::string& text);

 private:
  std::mutex mutex_;
  bool terminal_, shown_ = false;
};

}  // namespace morphe::run
