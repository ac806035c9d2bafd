#include "pipeline/run/stop_signal.hpp"

#include <fmt/format.h>
#include <pthread.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <initializer_list>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include "core/files/unfinished_path.hpp"
#include "core/motion/input_error.hpp"

namespace morphe::run {
namespace {

/// The registered StopSignal; never destroyed, because a signal may arrive while the process ends.
struct StopListener {
  std::mutex mutex;
  StopSignal* stop = nullptr;
};

StopListener& listener() {
  static auto* const instance = new StopListener;
  return *instance;
}

constexpr std::chrono::milliseconds kWaitStep{5};

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
  if (stop && stop->received_ == 0) {
    stop->received_ = signal;
    // A thread of its own, so that the next signal is handled meanwhile.
    stop->callback_thread_ = std::thread([stop] { stop->stop(); });
    return;
  }
  constexpr std::chrono::milliseconds kMaxWait{300};
  for (auto waited = kWaitStep; stop && !stop->returned_ && waited < kMaxWait; waited += kWaitStep)
    std::this_thread::sleep_for(kWaitStep);
  terminate_by_signal(signal);
}

void watch_stop_signals() {
  sigset_t watched;
  sigemptyset(&watched);
  for (const int signal : {SIGINT, SIGTERM}) {
    struct sigaction action {};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler != SIG_IGN) sigaddset(&watched, signal);
  }
  pthread_sigmask(SIG_BLOCK, &watched, nullptr);
  try {
    std::thread([watched] {
      for (int signal = 0; sigwait(&watched, &signal) == 0;) handle_stop_signal(signal);
    }).detach();
  } catch (const std::system_error& error) {
    throw InputError(fmt::format(
        "morphe: no thread can be started: {}: raise the limits of processes and memory "
        "(ulimit -u, ulimit -v)",
        error.code().message()));
  }
}

StopSignal::StopSignal(std::function<void()> on_stop) : on_stop_(std::move(on_stop)) {
  const std::lock_guard lock(listener().mutex);
  listener().stop = this;
}

void StopSignal::stop() {
  on_stop_();
  returned_ = true;
  if (received_ != SIGTERM) return;
  for (auto waited = kWaitStep; waited < kTermGrace && !ended_; waited += kWaitStep)
    std::this_thread::sleep_for(kWaitStep);
  if (!ended_) terminate_by_signal(SIGTERM);
}

StopSignal::~StopSignal() {
  ended_ = true;
  {
    const std::lock_guard lock(listener().mutex);
    listener().stop = nullptr;
  }
  if (callback_thread_.joinable()) callback_thread_.join();
}

}  // namespace morphe::run
