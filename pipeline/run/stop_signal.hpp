#pragma once

#include <atomic>
#include <functional>
#include <thread>

namespace morphe::run {

/// Starts a thread that waits for SIGINT and SIGTERM, unless they are ignored. It must be called
/// once, before any other thread is started. A signal ends the process as it does by default, but
/// unfinished paths are removed first (files::UnfinishedPath). If there is a StopSignal, it
/// receives the signal first.
void watch_stop_signals();

/// An object that receives the first signal instead of the process, so that running work can be
/// finished. The next signal ends the process at once, after at most 0.3 s in which the callback
/// may return. There may be one such object at a time. It has no effect without
/// watch_stop_signals().
class StopSignal {
 public:
  /// Registers the callback `told`, which is called on a thread of its own when the first signal
  /// arrives.
  explicit StopSignal(std::function<void()> told);
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;
  /// Returns the number of the signal that arrived, 0 if there is no signal yet. It may be called
  /// from any thread.
  int received_signal() const { return seen_; }

 private:
  friend void handle_stop_signal(int signal);
  std::function<void()> on_stop_;
  std::thread telling_;
  std::atomic<int> seen_ = 0;
  std::atomic<bool> answered_ = false;
};

}  // namespace morphe::run
