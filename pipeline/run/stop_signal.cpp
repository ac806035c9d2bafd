#include "pipeline/run/stop_signal.hpp"

#include <pthread.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <initializer_list>
#include <mutex>
#include <utility>

#include "core/files/unfinished.hpp"

namespace morphe::run {
namespace {

/// Never destroyed: a signal may come while the process ends.
struct StopListener {
  std::mutex mutex;
  StopSignal* stop = nullptr;
};

StopListener& listener() {
  static auto* const one = new StopListener;
  return *one;
}

/// A shell must see what the process died of.
[[noreturn]] void die_of(int signal) {
  files::remove_unfinished();
  std::signal(signal, SIG_DFL);
  sigset_t only;
  sigemptyset(&only);
  sigaddset(&only, signal);
  pthread_sigmask(SIG_UNBLOCK, &only, nullptr);
  ::raise(signal);
  ::_exit(128 + signal);
}

}  // namespace

void take_stop_signal(int signal) {
  const std::lock_guard lock(listener().mutex);
  StopSignal* const stop = listener().stop;
  if (stop && stop->seen_ == 0) {
    stop->seen_ = signal;
    stop->telling_ = std::thread([stop] {  // the next signal is not to wait for it
      stop->told_();
      stop->answered_ = true;
    });
    return;
  }
  constexpr std::chrono::milliseconds kLongest{300}, kStep{5};
  for (auto waited = kStep; stop && !stop->answered_ && waited < kLongest; waited += kStep)
    std::this_thread::sleep_for(kStep);
  die_of(signal);
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
    for (int signal = 0; sigwait(&waited_for, &signal) == 0;) take_stop_signal(signal);
  }).detach();
}

StopSignal::StopSignal(std::function<void()> told) : told_(std::move(told)) {
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
