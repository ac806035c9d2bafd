#pragma once

#include <atomic>
#include <functional>
#include <thread>

namespace morphe::run {

/// From here on a thread waits for SIGINT and SIGTERM, those that are not ignored. To be called
/// once, before any other thread is started. A signal is the process's, so what becomes of it is:
/// it ends the process, as if nobody had waited, but first takes away what is unfinished
/// (files::Unfinished). A StopSignal is told first.
void watch_stop_signals();

/// While it lives, the first signal does not end the process but is told here: work that is in hand
/// can be finished. The next one ends it at once, but for at most 0.3 s in which what was told is
/// answered. One at a time; nothing happens without
/// watch_stop_signals().
class StopSignal {
 public:
  /// `told` is called when the first comes, on a thread of its own.
  explicit StopSignal(std::function<void()> told);
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;
  /// Number of the signal that came, 0: none yet. From any thread.
  int seen() const { return seen_; }

 private:
  friend void take_stop_signal(int signal);
  std::function<void()> told_;
  std::thread telling_;
  std::atomic<int> seen_ = 0;
  std::atomic<bool> answered_ = false;
};

}  // namespace morphe::run
