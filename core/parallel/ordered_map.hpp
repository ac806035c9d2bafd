#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace morphe::parallel {

/// Read, parallel map, ordered write with a bounded number of items in flight: `next` and `write`
/// are never called from two threads at once and see the items in their order; `work` runs on up to
/// `jobs` threads. An exception in any of them ends the run and is thrown here.
///   next:  the next item, or null when there are no more
///   work:  item -> result
template <class Item, class Result>
struct OrderedMap {
  std::function<std::unique_ptr<Item>()> next;
  std::function<std::unique_ptr<Result>(const Item&)> work;
  std::function<void(const Result&)> write;
};

/// Type-erased engine of run(): keeps TBB out of the header.
void run_ordered(const std::function<std::shared_ptr<void>()>& next,
                 const std::function<std::shared_ptr<void>(const std::shared_ptr<void>&)>& work,
                 const std::function<void(const std::shared_ptr<void>&)>& write, int jobs);

template <class Item, class Result>
void run(const OrderedMap<Item, Result>& map, int jobs) {
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

/// work(0) … work(count - 1), in any order; inside a run's `work` its idle threads help. An
/// exception in any of them is thrown here.
void for_each_index(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace morphe::parallel
