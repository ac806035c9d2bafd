#pragma once

namespace CLI {
class App;
}

namespace morphe::commands {

/// --jobs N, 0 (as without it) for one thread a core. `jobs` must outlive the parsing.
void add_jobs_option(CLI::App& app, int& jobs);

/// How many threads that is.
int threads_of(int jobs);

}  // namespace morphe::commands
