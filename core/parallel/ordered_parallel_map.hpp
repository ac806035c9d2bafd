#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace morphe::parallel {

/// An ordered parallel map with a bounded number of items in flight: `next` and `write` are never
/// called concurrently and process the items in order; `work` runs on up to `jobs` threads. An
/// exception in any of them ends the run and is rethrown by run().
///   next:  returns the next item, or null at the end
///   work:  item -> result
template <class Item, class Result>
struct OrderedParallelMap {
  std::function<std::unique_ptr<Item>()> next;
  std::function<std::unique_ptr<Result>(const Item&)> work;
  std::function<void(const Result&)> write;
};

/// Type-erased implementation of run(), which keeps TBB out of the header.
void run_ordered(const std::function<std::shared_ptr<void>()>& next,
                 const std::function<std::shared_ptr<void>(const std::shared_ptr<void>&)>& work,
                 const std::function<void(const std::shared_ptr<void>&)>& write, int jobs);

/// Runs an ordered parallel map.
template <class Item, class Result>
void run(const OrderedParallelMap<Item, Result>& map, int jobs) {
  run_ordered([&] { return std::shared_ptr<void>(std::shared_ptr<Item>(map.next())); },
              [&](const std::shared_ptr<void>& item) {
                return std::shared_ptr<void>(
                    std::shared_ptr<Result>(map.work(*std::static_pointer_cast<Item>(item))));
              },
              [&](const std::shared_ptr<void>& result) {
                map.write(*std::static_pointer_cast<Result>(result));
              },
              jobs);
}

/// Calls work(0) … work(count - 1) in any order; within a run's `work`, its idle threads help. An
/// exception in any call is rethrown.
void for_each_index(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace morphe::parallel
