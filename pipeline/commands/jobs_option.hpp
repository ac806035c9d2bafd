#pragma once

namespace CLI {
class App;
}

namespace morphe::commands {

/// Adds --jobs N; 0 (the default) means one thread per core. `jobs` must outlive the parsing.
void add_jobs_option(CLI::App& app, int& jobs);

/// Returns the number of threads for a value of --jobs.
int threads_of(int jobs);

}  // namespace morphe::commands
