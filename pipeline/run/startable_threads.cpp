#include "pipeline/run/startable_threads.hpp"

#include <cerrno>
#include <future>
#include <iterator>
#include <memory>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace morphe::run {

int startable_threads(int count, int& error) {
  error = 0;
  std::promise<void> end;
  const std::shared_future<void> ended = end.get_future().share();
  std::vector<std::thread> threads;
  threads.reserve(count);
  try {
    while (std::ssize(threads) < count)
      threads.emplace_back([ended] {
        // The first allocation of a thread maps its arena, which later threads use again.
        const std::unique_ptr<char> arena(::new (std::nothrow) char);
        ended.wait();
      });
  } catch (const std::system_error& failure) {
    error = failure.code().value();
  } catch (const std::bad_alloc&) {
    error = ENOMEM;
  }
  end.set_value();
  for (std::thread& thread : threads) thread.join();
  return static_cast<int>(threads.size());
}

}  // namespace morphe::run
