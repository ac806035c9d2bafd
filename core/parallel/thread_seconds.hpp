#pragma once

#include <ctime>

namespace morphe::parallel {

/// Processor time of the calling thread so far [s]: what else the machine does counts as little as
/// possible.
inline double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace morphe::parallel
