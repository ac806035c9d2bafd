#pragma once

#include <map>
#include <string>

#include "core/parallel/thread_cpu_time.hpp"

namespace morphe::planning {

/// Returns the result of a step and adds the processor time of its thread, the only one that it
/// uses, to the summary's stage_seconds.
template <class Step>
auto time_stage(std::map<std::string, double>& seconds, const char* stage, const Step& step) {
  const double begin_s = parallel::thread_cpu_time_s();
  auto result = step();
  seconds[stage] += parallel::thread_cpu_time_s() - begin_s;
  return result;
}

}  // namespace morphe::planning
