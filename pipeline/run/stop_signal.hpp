#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <thread>

namespace morphe::run {

/// Starts a thread that waits for SIGINT and SIGTERM, unless they are ignored. It must be called
/// once, before any other thread is started. Throws InputError if the thread cannot be started. A
/// signal ends the process as usual, but first removes unfinished paths (files::UnfinishedPath); a
/// StopSignal may receive it instead.
void watch_stop_signals();

/// Receives the first signal instead of the process, so that running work can be finished. The next
/// signal ends the process, as soon as the callback for the first has returned, but after at most
/// 0.3 s. After a SIGTERM, whose senders kill what goes on, kTermGrace ends it in the same way.
/// There may be one such object at a time. It has no effect without watch_stop_signals().
class StopSignal {
 public:
  /// Registers a callback, which is called on a thread of its own when the first signal arrives.
  explicit StopSignal(std::function<void()> on_stop);
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;
  /// Returns the number of the first signal, 0 before it arrives. May be called from any thread.
  int received_signal() const { return received_; }

  /// The time that running work has after SIGTERM.
  static constexpr std::chrono::milliseconds kTermGrace{1500};

 private:
  friend void handle_stop_signal(int signal);
  void stop();
  std::function<void()> on_stop_;
  std::thread callback_thread_;
  std::atomic<int> received_ = 0;
  std::atomic<bool> returned_ = false, ended_ = false;
};

}  // namespace morphe::run
