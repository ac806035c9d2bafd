#pragma once

#include <map>
#include <mutex>
#include <string>

#include "core/parallel/thread_cpu_time.hpp"

namespace morphe::parallel {

/// Sums the processor time of stages [s] over the threads that share the clock.
class StageClock {
 public:
  /// Returns the result of step(), which must use this thread only, and adds its processor time.
  template <class Step>
  auto measure(const std::string& stage, const Step& step) {
    const double begin_s = thread_cpu_time_s();
    auto result = step();
    const double taken_s = thread_cpu_time_s() - begin_s;
    const std::lock_guard lock(mutex_);
    seconds_[stage] += taken_s;
    return result;
  }

  /// Returns the sums by stage [s].
  std::map<std::string, double> seconds() const {
    const std::lock_guard lock(mutex_);
    return seconds_;
  }

 private:
  mutable std::mutex mutex_;
  std::map<std::string, double> seconds_;
};

}  // namespace morphe::parallel
