#pragma once

#include <chrono>

namespace morphe::study {

/// Seconds that something took.
template <class Work>
double seconds(const Work& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace morphe::study
