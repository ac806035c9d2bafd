#pragma once

#include <ctime>

namespace morphe::parallel {

/// Returns the calling thread's processor time [s], little affected by the machine's other load.
inline double thread_cpu_time_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace morphe::parallel
