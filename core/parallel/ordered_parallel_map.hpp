#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace morphe::parallel {

/// An ordered parallel map with a bounded number of items in flight. An exception in any of the
/// three functions ends the run and is rethrown by run().
///   next:   returns the next item, or null at the end; one call at a time
///   work:   item -> result; on up to `jobs` threads
///   write:  takes the results in the order of the items; one call at a time
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

/// Runs an ordered parallel map on `jobs` >= 1 threads.
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

/// Calls work(0) … work(count - 1) in any order, on this and idle threads; rethrows exceptions.
void for_each_index(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace morphe::parallel
