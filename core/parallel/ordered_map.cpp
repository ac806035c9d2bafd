#include "core/parallel/ordered_map.hpp"

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

/// What was written before a loop began is there for its threads. Its address is known without
/// looking at the loop's functions, which are such a thing.
char begun = 0;

/// From here to the end of its block, by an exception too, `place` is this thread's.
struct Turn {
  explicit Turn(void* which) : place(which) { take_over(place); }
  ~Turn() { hand_over(place); }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;
  void* place;
};

/// The items in flight. A pipeline that an exception ends forgets what it was handed, so they are
/// owned here: at most `count` are in flight and they leave in order, so item k has its slot, the
/// k-th modulo `count`, for itself.
struct InFlight {
  explicit InFlight(std::size_t count) : slots(count) {}
  ~InFlight() {
    for (auto& slot : slots) take_over(&slot);
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
  char reading = 0, writing = 0;  // the serial filters: one call is handed over to the next
  const auto read = tbb::make_filter<void, Item*>(
      filter_mode::serial_in_order, [&](tbb::flow_control& control) -> Item* {
        take_over(&begun);
        const Turn turn(&reading);
        Item& item = items.slots[given++ % items.slots.size()];
        const Turn of_item(&item);
        item = next();
        if (!item) control.stop();
        return &item;
      });
  const auto map = tbb::make_filter<Item*, Item*>(filter_mode::parallel, [&](Item* item) {
    take_over(&begun);
    const Turn of_item(item);
    *item = work(*item);
    return item;
  });
  const auto emit = tbb::make_filter<Item*, void>(filter_mode::serial_in_order, [&](Item* item) {
    take_over(&begun);
    const Turn of_item(item);
    const Turn turn(&writing);
    write(*item);
    item->reset();
  });
  tbb::task_arena arena(jobs);
  hand_over(&begun);
  arena.execute([&] { tbb::parallel_pipeline(items.slots.size(), read & map & emit); });
  take_over(&reading);
  take_over(&writing);
}

void for_each_index(std::size_t count, const std::function<void(std::size_t)>& work) {
  char done = 0;
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
