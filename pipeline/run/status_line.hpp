#pragma once

#include <mutex>
#include <string>

namespace morphe::run {

/// The last line of a terminal, on standard error, that says how far something is: it is rewritten
/// in place and taken away before anything else is printed, so that neither results nor errors hang
/// on to it. Never wider than the terminal. Where standard error is a file or a pipe there is none.
/// Safe to use from several threads.
class StatusLine {
 public:
  StatusLine();
  ~StatusLine() { clear(); }
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  bool on_terminal() const { return terminal_; }
  void show(const std::string& text);
  void clear();
  /// A line of its own, which stays; on a file or pipe, too.
  void print(const std::string& text);

 private:
  std::mutex mutex_;
  bool terminal_, shown_ = false;
};

}  // namespace morphe::run
