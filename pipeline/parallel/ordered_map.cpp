#include "pipeline/parallel/ordered_map.hpp"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>
#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace morphe::parallel {
namespace {

/// TBB hands items from thread to thread inside its own library, where the thread sanitizer sees
/// nothing. These tell it what TBB guarantees: what was done before a hand_over of `place` is seen
/// after its take_over.
void hand_over([[maybe_unused]] void* place) {
#ifdef __SANITIZE_THREAD__
  __tsan_release(place);
#endif
}
void take_over([[maybe_unused]] void* place) {
#ifdef __SANITIZE_THREAD__
  __tsan_acquire(place);
#endif
}

}  // namespace

void run_ordered(const std::function<std::shared_ptr<void>()>& next,
                 const std::function<std::shared_ptr<void>(const std::shared_ptr<void>&)>& work,
                 const std::function<void(const std::shared_ptr<void>&)>& write, int jobs) {
  using tbb::filter_mode;
  using Item = std::shared_ptr<void>;
  const auto threads = static_cast<std::size_t>(jobs);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  char reading = 0, writing = 0;  // the serial filters: one call is handed over to the next
  const auto read = tbb::make_filter<void, Item*>(filter_mode::serial_in_order,
                                                  [&](tbb::flow_control& control) -> Item* {
                                                    take_over(&reading);
                                                    auto item = std::make_unique<Item>(next());
                                                    hand_over(&reading);
                                                    if (!*item) {
                                                      control.stop();
                                                      return nullptr;
                                                    }
                                                    hand_over(item.get());
                                                    return item.release();
                                                  });
  const auto map = tbb::make_filter<Item*, Item*>(filter_mode::parallel, [&](Item* item) {
    take_over(item);
    *item = work(*item);
    hand_over(item);
    return item;
  });
  const auto emit = tbb::make_filter<Item*, void>(filter_mode::serial_in_order, [&](Item* item) {
    take_over(item);
    take_over(&writing);
    const std::unique_ptr<Item> result(item);
    write(*result);
    hand_over(&writing);
  });
  tbb::task_arena arena(jobs);
  arena.execute([&] { tbb::parallel_pipeline(2 * threads, read & map & emit); });
  take_over(&reading);
  take_over(&writing);
}

void for_each_index(std::size_t count, const std::function<void(std::size_t)>& work) {
  char begun = 0, done = 0;
  hand_over(&begun);
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, count, 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        take_over(&begun);
        for (std::size_t k = range.begin(); k < range.end(); ++k) work(k);
        hand_over(&done);
      },
      tbb::simple_partitioner());
  take_over(&done);
}

}  // namespace morphe::parallel
