#include "pipeline/run/ordered_map.hpp"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>

namespace morphe {

void run_ordered(const std::function<std::shared_ptr<void>()>& next,
                 const std::function<std::shared_ptr<void>(const std::shared_ptr<void>&)>& work,
                 const std::function<void(const std::shared_ptr<void>&)>& write, int jobs) {
  using Token = std::shared_ptr<void>;
  using tbb::filter_mode;
  const auto threads = static_cast<std::size_t>(jobs);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  const auto read = tbb::make_filter<void, Token>(filter_mode::serial_in_order,
                                                  [&](tbb::flow_control& control) -> Token {
                                                    Token item = next();
                                                    if (!item) control.stop();
                                                    return item;
                                                  });
  const auto map = tbb::make_filter<Token, Token>(filter_mode::parallel,
                                                  [&](const Token& item) { return work(item); });
  const auto emit = tbb::make_filter<Token, void>(filter_mode::serial_in_order,
                                                  [&](const Token& result) { write(result); });
  tbb::task_arena arena(jobs);
  arena.execute([&] { tbb::parallel_pipeline(2 * threads, read & map & emit); });
}

}  // namespace morphe
