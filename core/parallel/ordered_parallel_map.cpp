#include "core/parallel/ordered_parallel_map.hpp"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>
#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

#include <vector>

namespace morphe::parallel {
namespace {

/// TBB passes items between threads out of sight of the thread sanitizer. These declare its
/// guarantee: writes before release_to_threads are visible after acquire_from_threads.
void release_to_threads([[maybe_unused]] void* place) {
#ifdef __SANITIZE_THREAD__
  __tsan_release(place);
#endif
}
void acquire_from_threads([[maybe_unused]] void* place) {
#ifdef __SANITIZE_THREAD__
  __tsan_acquire(place);
#endif
}

/// Marks that writes before a loop are visible to its threads. Its address is known without reading
/// the loop's functions, which are themselves such writes.
char loop_begin_mark = 0;

/// Acquires `place` for this thread, and releases it at the end of the scope, also by an exception.
struct ScopedAcquire {
  explicit ScopedAcquire(void* which) : place(which) { acquire_from_threads(place); }
  ~ScopedAcquire() { release_to_threads(place); }
  ScopedAcquire(const ScopedAcquire&) = delete;
  ScopedAcquire& operator=(const ScopedAcquire&) = delete;
  void* place;
};

/// The items in flight, owned here because TBB does not destroy those of a pipeline that an
/// exception ends. At most `count`, they leave in order, so item k has the slot k modulo `count`.
struct InFlight {
  explicit InFlight(int count) : slots(count) {}
  ~InFlight() {
    for (auto& slot : slots) acquire_from_threads(&slot);
  }
  InFlight(const InFlight&) = delete;
  InFlight& operator=(const InFlight&) = delete;
  std::vector<std::shared_ptr<void>> slots;
};

}  // namespace

void run_ordered(const std::function<std::shared_ptr<void>()>& next,
                 const std::function<std::shared_ptr<void>(const std::shared_ptr<void>&)>& work,
                 const std::function<void(const std::shared_ptr<void>&)>& write, int jobs) {
  using tbb::filter_mode;
  using Item = std::shared_ptr<void>;
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, jobs);
  InFlight items(2 * jobs);
  std::size_t items_read = 0;
  char read_mark = 0, write_mark = 0;  // serial filters: each call synchronises with the next
  const auto read = tbb::make_filter<void, Item*>(
      filter_mode::serial_in_order, [&](tbb::flow_control& control) -> Item* {
        acquire_from_threads(&loop_begin_mark);
        const ScopedAcquire serial_access(&read_mark);
        Item& item = items.slots[items_read++ % items.slots.size()];
        const ScopedAcquire item_access(&item);
        item = next();
        if (!item) control.stop();
        return &item;
      });
  const auto map = tbb::make_filter<Item*, Item*>(filter_mode::parallel, [&](Item* item) {
    acquire_from_threads(&loop_begin_mark);
    const ScopedAcquire item_access(item);
    *item = work(*item);
    return item;
  });
  const auto emit = tbb::make_filter<Item*, void>(filter_mode::serial_in_order, [&](Item* item) {
    acquire_from_threads(&loop_begin_mark);
    const ScopedAcquire item_access(item);
    const ScopedAcquire serial_access(&write_mark);
    write(*item);
    item->reset();
  });
  tbb::task_arena arena(jobs);
  release_to_threads(&loop_begin_mark);
  arena.execute([&] { tbb::parallel_pipeline(items.slots.size(), read & map & emit); });
  acquire_from_threads(&read_mark);
  acquire_from_threads(&write_mark);
}

void for_each_index(std::size_t count, const std::function<void(std::size_t)>& work) {
  char loop_end_mark = 0;
  release_to_threads(&loop_begin_mark);
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, count, 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        acquire_from_threads(&loop_begin_mark);
        for (std::size_t k = range.begin(); k < range.end(); ++k) work(k);
        release_to_threads(&loop_end_mark);
      },
      tbb::simple_partitioner());
  acquire_from_threads(&loop_end_mark);
}

}  // namespace morphe::parallel
