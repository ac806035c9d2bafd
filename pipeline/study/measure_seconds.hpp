#pragma once

#include <chrono>

namespace morphe::study {

/// Calls `work` and returns the wall-clock time that it takes [s].
template <class Work>
double measure_seconds(const Work& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace morphe::study
