#pragma once

#include <map>
#include <string>

#include "core/parallel/thread_seconds.hpp"

namespace morphe::planning {

/// What a step makes; the processor time of its thread, which is all that it uses, is added to the
/// summary's stage_seconds.
template <class Step>
auto timed(std::map<std::string, double>& seconds, const char* stage, const Step& step) {
  const double begin_s = parallel::thread_seconds();
  auto result = step();
  seconds[stage] += parallel::thread_seconds() - begin_s;
  return result;
}

}  // namespace morphe::planning
