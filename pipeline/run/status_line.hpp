#pragma once

#include <mutex>
#include <string>

namespace morphe::run {

/// The last line on a terminal, which shows progress on standard error. It is rewritten in place,
/// removed before print() prints, and cut to the width of the terminal. If standard error is a file
/// or a pipe, it is not shown. It is safe to use from several threads.
class StatusLine {
 public:
  StatusLine();
  ~StatusLine() { clear(); }
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  /// Returns true if standard error is a terminal that can rewrite a line.
  bool on_terminal() const { return terminal_; }
  /// Replaces the text of the status line, or removes it.
  void show(const std::string& text);
  void clear();
  /// Prints a permanent line, also to a file or pipe.
  void print(const std::string& text);

 private:
  std::mutex mutex_;
  bool terminal_, shown_ = false;
};

}  // namespace morphe::run
