#pragma once

#include <atomic>
#include <csignal>

namespace morphe::run {

/// While it lives, the first SIGINT or SIGTERM does not end the process but is waiting here; after
/// it was seen, the next one ends the process as usual. Signals that were ignored stay ignored. For
/// this thread and those it starts.
class StopSignal {
 public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;
  /// Number of the signal that came, 0: none yet. From any thread.
  int seen();

 private:
  sigset_t before_{}, waited_for_{};
  int descriptor_ = -1;
  std::atomic<int> seen_ = 0;
};

}  // namespace morphe::run
