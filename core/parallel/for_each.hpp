#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "core/parallel/ordered_parallel_map.hpp"

namespace morphe::parallel {

/// Calls write(work(index)) for index = 0, 1, … count - 1 in order, with `work` on several threads.
template <class Result>
void ordered_for_each(int count, int jobs, const std::function<Result(std::uint64_t)>& work,
                      const std::function<void(const Result&)>& write) {
  OrderedParallelMap<std::uint64_t, Result> map;
  map.next = [next = 0, count]() mutable {
    return next == count ? nullptr : std::make_unique<std::uint64_t>(next++);
  };
  map.work = [&](const std::uint64_t& index) { return std::make_unique<Result>(work(index)); };
  map.write = write;
  run(map, jobs);
}

}  // namespace morphe::parallel
