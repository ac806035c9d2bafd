#include "pipeline/run/stop_signal.hpp"

#include <pthread.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <initializer_list>

namespace morphe::run {

StopSignal::StopSignal() {
  sigemptyset(&waited_for_);
  for (const int signal : {SIGINT, SIGTERM}) {
    struct sigaction action {};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler != SIG_IGN) sigaddset(&waited_for_, signal);
  }
  pthread_sigmask(SIG_BLOCK, &waited_for_, &before_);
  descriptor_ = ::signalfd(-1, &waited_for_, SFD_NONBLOCK | SFD_CLOEXEC);
}

StopSignal::~StopSignal() {
  if (descriptor_ >= 0) ::close(descriptor_);
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

int StopSignal::seen() {
  signalfd_siginfo info;
  if (seen_ == 0 && descriptor_ >= 0 &&
      ::read(descriptor_, &info, sizeof info) == static_cast<ssize_t>(sizeof info)) {
    seen_ = static_cast<int>(info.ssi_signo);
    pthread_sigmask(SIG_UNBLOCK, &waited_for_, nullptr);
  }
  return seen_;
}

}  // namespace morphe::run
