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

/// TBB passes items between threads inside its own library, which the thread sanitizer cannot see.
/// These functions declare the guarantees of TBB to it: writes before release_to_threads of `place`
/// are visible after its acquire_from_threads.
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

/// Marks that writes before a loop are visible to its threads. The address of this variable is
/// known without reading the loop's functions, which are themselves such writes.
char begun = 0;

/// Acquires `place` for this thread until the end of the scope, including by an exception.
struct ScopedAcquire {
  explicit ScopedAcquire(void* which) : place(which) { acquire_from_threads(place); }
  ~ScopedAcquire() { release_to_threads(place); }
  ScopedAcquire(const ScopedAcquire&) = delete;
  ScopedAcquire& operator=(const ScopedAcquire&) = delete;
  void* place;
};

/// The items in flight. TBB does not destroy the items of a pipeline that an exception ends, so
/// they are owned here: at most `count` are in flight and they leave in order, so item k has slot k
/// modulo `count` to itself.
struct InFlight {
  explicit InFlight(std::size_t count) : slots(count) {}
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
  const auto threads = static_cast<std::size_t>(jobs);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  InFlight items(2 * threads);
  std::size_t given = 0;
  char reading = 0, writing = 0;  // serial filters: each call synchronises with the next
  const auto read = tbb::make_filter<void, Item*>(
      filter_mode::serial_in_order, [&](tbb::flow_control& control) -> Item* {
        acquire_from_threads(&begun);
        const ScopedAcquire turn(&reading);
        Item& item = items.slots[given++ % items.slots.size()];
        const ScopedAcquire of_item(&item);
        item = next();
        if (!item) control.stop();
        return &item;
      });
  const auto map = tbb::make_filter<Item*, Item*>(filter_mode::parallel, [&](Item* item) {
    acquire_from_threads(&begun);
    const ScopedAcquire of_item(item);
    *item = work(*item);
    return item;
  });
  const auto emit = tbb::make_filter<Item*, void>(filter_mode::serial_in_order, [&](Item* item) {
    acquire_from_threads(&begun);
    const ScopedAcquire of_item(item);
    const ScopedAcquire turn(&writing);
    write(*item);
    item->reset();
  });
  tbb::task_arena arena(jobs);
  release_to_threads(&begun);
  arena.execute([&] { tbb::parallel_pipeline(items.slots.size(), read & map & emit); });
  acquire_from_threads(&reading);
  acquire_from_threads(&writing);
}

void for_each_index(std::size_t count, const std::function<void(std::size_t)>& work) {
  char done = 0;
  release_to_threads(&begun);
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, count, 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        acquire_from_threads(&begun);
        for (std::size_t k = range.begin(); k < range.end(); ++k) work(k);
        release_to_threads(&done);
      },
      tbb::simple_partitioner());
  acquire_from_threads(&done);
}

}  // namespace morphe::parallel
