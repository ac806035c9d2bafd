#include "pipeline/commands/jobs_option.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <thread>

namespace morphe::commands {

void add_jobs_option(CLI::App& app, int& jobs) {
  app.add_option("--jobs", jobs, "Number of threads (default: 0, one per core)")
      ->check(CLI::NonNegativeNumber);
}

int threads_of(int jobs) {
  return jobs > 0 ? jobs : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace morphe::commands
