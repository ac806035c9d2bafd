#include "pipeline/run/stop_signal.hpp"

#include <pthread.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <initializer_list>
#include <mutex>
#include <utility>

#include "core/files/unfinished_path.hpp"

namespace morphe::run {
namespace {

/// The registered StopSignal. The listener is never destroyed because a signal may arrive while the
/// process ends.
struct StopListener {
  std::mutex mutex;
  StopSignal* stop = nullptr;
};

StopListener& listener() {
  static auto* const one = new StopListener;
  return *one;
}

/// Ends the process by the signal itself, so that a shell sees the cause of its death.
[[noreturn]] void terminate_by_signal(int signal) {
  files::remove_unfinished_paths();
  std::signal(signal, SIG_DFL);
  sigset_t only;
  sigemptyset(&only);
  sigaddset(&only, signal);
  pthread_sigmask(SIG_UNBLOCK, &only, nullptr);
  ::raise(signal);
  ::_exit(128 + signal);
}

}  // namespace

void handle_stop_signal(int signal) {
  const std::lock_guard lock(listener().mutex);
  StopSignal* const stop = listener().stop;
  if (stop && stop->seen_ == 0) {
    stop->seen_ = signal;
    stop->telling_ =
        std::thread([stop] {  // a thread of its own, so that the next signal is handled meanwhile
          stop->on_stop_();
          stop->answered_ = true;
        });
    return;
  }
  constexpr std::chrono::milliseconds kMaxWait{300}, kWaitStep{5};
  for (auto waited = kWaitStep; stop && !stop->answered_ && waited < kMaxWait; waited += kWaitStep)
    std::this_thread::sleep_for(kWaitStep);
  terminate_by_signal(signal);
}

void watch_stop_signals() {
  sigset_t waited_for;
  sigemptyset(&waited_for);
  for (const int signal : {SIGINT, SIGTERM}) {
    struct sigaction action {};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler != SIG_IGN) sigaddset(&waited_for, signal);
  }
  pthread_sigmask(SIG_BLOCK, &waited_for, nullptr);
  std::thread([waited_for] {
    for (int signal = 0; sigwait(&waited_for, &signal) == 0;) handle_stop_signal(signal);
  }).detach();
}

StopSignal::StopSignal(std::function<void()> told) : on_stop_(std::move(told)) {
  const std::lock_guard lock(listener().mutex);
  listener().stop = this;
}

StopSignal::~StopSignal() {
  {
    const std::lock_guard lock(listener().mutex);
    listener().stop = nullptr;
  }
  if (telling_.joinable()) telling_.join();
}

}  // namespace morphe::run
