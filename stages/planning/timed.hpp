#pragma once

#include <chrono>
#include <map>
#include <string>

namespace morphe::planning {

/// What a step makes; its wall clock is added to the summary's stage_seconds.
template <class Step>
auto timed(std::map<std::string, double>& seconds, const char* stage, const Step& step) {
  const auto begin = std::chrono::steady_clock::now();
  auto result = step();
  seconds[stage] += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

}  // namespace morphe::planning
